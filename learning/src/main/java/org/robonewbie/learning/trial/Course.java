package org.robonewbie.learning.trial;

import org.robonewbie.agent.walk.Stance;
import org.robonewbie.agent.walk.WalkEngine;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.PostureFollower;

/**
 * A trial on foot: a robot that stands in the stance, somewhat disturbed, and plays one motion after the other. What it does is
 * measured from where it stood at first.
 *
 * <pre>{@code
 * Course course = new Course(seed, 3);
 * course.play(walk);
 * boolean good = course.play(stop) && course.endsInStance();
 * }</pre>
 */
public final class Course {

    private static final double NOISE_DEGREES = 1;
    private static final double SETTLING_SECONDS = 0.6;
    private static final double POSTURE_DEGREES = 3;
    private static final double UPRIGHT = 0.98;
    private static final double REST = 0.05;

    private final TrialRobot robot;
    private final Watch watch = new Watch();
    private final TrialObserver observer;
    private final Vector3 start;
    private final double startDegrees;
    private double lastDegrees;
    private double turnedDegrees;

    /**
     * Brings a robot into the stance by way of a nearby posture.
     *
     * @param seed chooses the disturbances
     * @param newtons strength of the pushes
     */
    public Course(long seed, double newtons) {
        this(seed, newtons, TrialObserver.NONE);
    }

    /**
     * Brings a robot into the stance by way of a nearby posture, with an observer.
     *
     * @param seed chooses the disturbances
     * @param newtons strength of the pushes
     * @param guest observes each cycle from now on
     */
    public Course(long seed, double newtons, TrialObserver guest) {
        this(TrialRobot.START, seed, newtons, guest);
    }

    /**
     * Brings a robot into the stance at a given place by way of a nearby posture, with an observer.
     *
     * @param place initial position of the torso's centre, in metres in the world frame
     * @param seed chooses the disturbances
     * @param newtons strength of the pushes
     * @param guest observes each cycle from now on
     */
    public Course(Vector3 place, long seed, double newtons, TrialObserver guest) {
        robot = new TrialRobot(place);
        Disturbance disturbance = new Disturbance(seed, newtons);
        robot.moveTo(disturbance.near(Stance.POSTURE, NOISE_DEGREES), 600, TrialObserver.NONE);
        robot.moveTo(Stance.POSTURE, 400, TrialObserver.NONE);
        robot.hold(0.2, TrialObserver.NONE);
        start = robot.torso();
        startDegrees = robot.headingDegrees();
        lastDegrees = startDegrees;
        observer = guest.and(disturbance).and(this::follow).and(watch);
    }

    /**
     * Plays a motion, unless the robot has fallen.
     *
     * @param motion the motion
     * @return whether the robot is still on its feet
     */
    public boolean play(Motion motion) {
        return !watch.hasFallen() && robot.play(motion, observer);
    }

    /**
     * Walks for one cycle, unless the robot has fallen.
     *
     * @param engine the walk
     * @param follower leads the robot's joints
     * @return whether the robot is still on its feet
     */
    public boolean walk(WalkEngine engine, PostureFollower follower) {
        return !watch.hasFallen() && robot.walk(engine, follower, observer);
    }

    /**
     * Waits a moment and looks whether the robot stands as it began.
     *
     * @return whether it stands upright, at rest and in the stance
     */
    public boolean endsInStance() {
        return !watch.hasFallen()
                && robot.hold(SETTLING_SECONDS, observer)
                && robot.uprightness() > UPRIGHT
                && robot.velocity().length() < REST
                && robot.posture().largestDifference(Stance.POSTURE) < POSTURE_DEGREES;
    }

    /** {@return the robot on this course} */
    public TrialRobot robot() {
        return robot;
    }

    /** {@return the stability of the robot as watched since the beginning} */
    public Watch watch() {
        return watch;
    }

    /** {@return metres that the robot has moved along its first heading} */
    public double forward() {
        return inFirstHeading().x();
    }

    /** {@return metres that the robot has moved to the left of its first heading} */
    public double left() {
        return inFirstHeading().y();
    }

    /** {@return degrees that the robot has turned, positive to the left, whole turns included} */
    public double turnedDegrees() {
        return turnedDegrees;
    }

    /**
     * Returns a place as seen from the robot at the beginning.
     *
     * @param forwardMetres ahead of the torso
     * @param leftMetres to the left of the torso
     * @param heightMetres above the ground
     * @return the place in the world frame, metres
     */
    public Vector3 place(double forwardMetres, double leftMetres, double heightMetres) {
        double cosine = Math.cos(Math.toRadians(startDegrees));
        double sine = Math.sin(Math.toRadians(startDegrees));
        return new Vector3(
                start.x() + cosine * forwardMetres - sine * leftMetres,
                start.y() + sine * forwardMetres + cosine * leftMetres,
                heightMetres);
    }

    /**
     * Returns a place relative to the robot at the beginning.
     *
     * @param world a place in the world frame
     * @return metres forward, to the left and up from the torso
     */
    public Vector3 seen(Vector3 world) {
        Vector3 way = world.minus(start);
        double cosine = Math.cos(Math.toRadians(startDegrees));
        double sine = Math.sin(Math.toRadians(startDegrees));
        return new Vector3(cosine * way.x() + sine * way.y(), -sine * way.x() + cosine * way.y(), way.z());
    }

    private Vector3 inFirstHeading() {
        return seen(robot.torso());
    }

    private boolean follow(TrialRobot now) {
        double degrees = now.headingDegrees();
        turnedDegrees += Math.IEEEremainder(degrees - lastDegrees, 360);
        lastDegrees = degrees;
        return true;
    }
}

package org.robonewbie.learning.trial;

import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.agent.walk.WalkEngine;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.motion.Interpolation;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.MotionPlayer;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.nao.motion.PostureFollower;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.world.Ball;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.Performer;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.SensorReadings;
import org.robonewbie.trial.Trial;

/**
 * A robot alone in a world of its own, without server and sockets, that lives through the same cycle as with an agent: it
 * senses its joints in hundredths of a degree, and a speed that answers the state after step k acts in step k + 2.
 *
 * <p>It begins on the left half of the pitch and looks along the world's x axis to the right goal; the ball lies far aside.
 *
 * <pre>{@code
 * TrialRobot robot = new TrialRobot();
 * robot.play(walk, TrialObserver.NONE);
 * double metres = robot.torso().x() - TrialRobot.START.x();
 * }</pre>
 */
public final class TrialRobot {

    /** Where the centre of the torso is at first, in metres in the world frame. */
    public static final Vector3 START = new Vector3(-4.5, 1.5, 0.39);

    private static final Vector3 BALL_ASIDE = new Vector3(0, -3.5, 0.042);
    private static final Joint[] JOINTS = Joint.values();

    private final Trial trial;
    private final Robot robot;
    private final JointStates joints = new JointStates();
    private final Motors motors = new Motors(joints);
    private Consumer<SensorReadings> deed = readings -> {};

    /** Places a robot at {@link #START} with all joints at 0. */
    public TrialRobot() {
        this(START);
    }

    /**
     * Places a robot with all joints at 0.
     *
     * @param start position of the torso's centre, in metres in the world frame; the height does not matter
     */
    public TrialRobot(Vector3 start) {
        Scene scene = Scene.of(RobotStart.at(start.x(), start.y()))
                .withBall(BALL_ASIDE)
                .withoutNoise();
        trial = Trial.direct(scene, 0, Performer.ofPolicy(this::speeds));
        robot = trial.robot(0);
    }

    /**
     * Plays a motion to its end.
     *
     * @param motion the motion
     * @param observer sees each cycle and can break off
     * @return whether the observer let it play to the end
     */
    public boolean play(Motion motion, TrialObserver observer) {
        MotionPlayer player = new MotionPlayer(motion, Interpolation.LINEAR);
        while (!player.isFinished()) {
            if (!cycle(readings -> player.step(motors), observer)) {
                return false;
            }
        }
        return true;
    }

    /**
     * Moves to a posture.
     *
     * @param posture where to go
     * @param millis how long it takes
     * @param observer sees each cycle and can break off
     * @return whether the observer let it move to the end
     */
    public boolean moveTo(Posture posture, int millis, TrialObserver observer) {
        return play(new Motion("move", List.of(new Keyframe(millis, posture))), observer);
    }

    /**
     * Waits with motors that hold their joints, as between two motions.
     *
     * @param seconds how long
     * @param observer sees each cycle and can break off
     * @return whether the observer let it wait to the end
     */
    public boolean hold(double seconds, TrialObserver observer) {
        MotionPlayer nothing = new MotionPlayer(new Motion("hold", List.of()), Interpolation.LINEAR);
        for (long i = Math.round(seconds / Cycle.SECONDS); i > 0; i--) {
            if (!cycle(readings -> nothing.step(motors), observer)) {
                return false;
            }
        }
        return true;
    }

    /**
     * Walks for one cycle.
     *
     * @param engine the walk
     * @param follower leads these motors, see {@link #follower}
     * @param observer sees the cycle and can break off
     * @return whether the observer lets it go on
     */
    public boolean walk(WalkEngine engine, PostureFollower follower, TrialObserver observer) {
        return cycle(
                readings -> {
                    Vector3 gyro = SimSparkFrame.toBody(readings.gyro());
                    engine.feel(new TorsoMotion(gyro, SimSparkFrame.toBody(readings.acceleration())));
                    follower.follow(engine.next());
                },
                observer);
    }

    /**
     * Creates a follower that leads this robot from posture to posture.
     *
     * @return a follower that begins where the robot is
     */
    public PostureFollower follower() {
        return new PostureFollower(motors);
    }

    /**
     * Pushes the torso during the next cycle.
     *
     * @param newtons force in the world frame
     */
    public void push(Vector3 newtons) {
        robot.push(newtons);
    }

    /** {@return the ball of this robot's world} */
    public Ball ball() {
        return trial.ball();
    }

    /** {@return what is true now} */
    public Moment now() {
        return trial.now();
    }

    /** {@return simulated seconds since the robot was placed} */
    public double seconds() {
        return trial.seconds();
    }

    /** {@return the position of the torso's centre in the world frame, metres} */
    public Vector3 torso() {
        return robot.torso().position();
    }

    /** {@return whether the torso is tilted by more than 60 degrees or its centre is lower than 0.2 m} */
    public boolean isFallen() {
        return robot.isFallen();
    }

    /** {@return the uprightness of the torso, the cosine of its tilt: 1 upright, 0 lying, -1 upside down} */
    public double uprightness() {
        return robot.torso().rotation().zz();
    }

    /** {@return the upward component of the chest's direction: 1 straight up, as when lying on the back, -1 straight down} */
    public double chestUp() {
        return robot.torso().rotation().axisY().z();
    }

    /**
     * {@return the upward component of the left side's direction: 1 straight up, as when lying on the right side, -1 straight
     * down}
     */
    public double leftSideUp() {
        return -robot.torso().rotation().axisX().z();
    }

    /** {@return the heading of the torso in the world frame, degrees, -180 to 180; 0 at first, positive to the left} */
    public double headingDegrees() {
        return robot.headingDegrees();
    }

    /** {@return the velocity of the torso in the world frame, metres per second} */
    public Vector3 velocity() {
        return robot.torsoVelocity();
    }

    /** {@return the angular velocity of the torso in degrees per second about its own axes} */
    public Vector3 turning() {
        return robot.gyroDegreesPerSecond();
    }

    /**
     * Returns the pose of a link.
     *
     * @param link name of a link of the robot's model
     * @return its pose in the world frame
     */
    public BodyPose link(String link) {
        return robot.linkPose(robot.model().linkIndex(link));
    }

    /**
     * Adds up where the robot's mass is.
     *
     * @return its centre of mass in the world frame, metres
     */
    public Vector3 centreOfMass() {
        Vector3 sum = Vector3.ZERO;
        double mass = 0;
        List<Link> links = robot.model().links();
        for (int i = 0; i < links.size(); i++) {
            sum = sum.plus(robot.linkPose(i).position().times(links.get(i).massKg()));
            mass += links.get(i).massKg();
        }
        return sum.times(1 / mass);
    }

    /**
     * Returns the speed that the last cycle asked of a joint.
     *
     * @param joint a joint
     * @return its commanded speed in degrees per second
     */
    public double commandedDegreesPerSecond(Joint joint) {
        return motors.sentDegreesPerSecond(joint);
    }

    /** {@return the true joint angles} */
    public Posture posture() {
        return trial.now().robot().joints();
    }

    private boolean cycle(Consumer<SensorReadings> nextDeed, TrialObserver observer) {
        deed = nextDeed;
        trial.step();
        return observer.goOn(this);
    }

    private double[] speeds(SensorReadings readings) {
        for (Joint joint : JOINTS) {
            joints.sense(joint, readings.degrees(joint));
        }
        deed.accept(readings);
        motors.endCycle();
        return Arrays.stream(JOINTS).mapToDouble(motors::sentDegreesPerSecond).toArray();
    }
}

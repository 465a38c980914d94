package org.robonewbie.agent.walk;

import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.nao.kinematics.InverseKinematics;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.MutablePosture;

/**
 * Turns a wanted velocity into one posture for each cycle. Pure calculation, without a connection.
 *
 * <p>It plans one step at a time. At the beginning of a step the velocity comes nearer to the wanted one, and the place follows
 * where the swinging foot has to come down so that the middle between the feet moves with that velocity: seen from the
 * standing foot, as far ahead as the robot walks in the time of one step. For a step aside or a turn the leg on that side opens,
 * and the other one follows. In each cycle {@link Step} tells where both feet and the torso are, inverse kinematics finds the
 * angles of the legs, and the sense of balance corrects ankles, hips and the place of the next step.
 *
 * <p>The walk begins and ends with a step on the spot in which it passes over from and to the {@link Stance}.
 */
public final class WalkEngine {

    private static final int CYCLE_MILLIS = 20;

    private final WalkStyle style;
    private final InverseKinematics kinematics = new InverseKinematics(RobotType.TYPE_0);
    private final Balance balance = new Balance();
    private final int cyclesPerStep;
    private final Pace wanted = new Pace();
    private final Pace velocity = new Pace();
    private final MovingPlace left = new MovingPlace(FootPlace.LEFT);
    private final MovingPlace right = new MovingPlace(FootPlace.RIGHT);
    private final Carriage carriage;
    private final Step step;
    private final Correction correction = new Correction();
    private Leg leg = Leg.LEFT;
    private final MutablePosture walking = new MutablePosture(Stance.POSTURE);
    private final MutablePosture next = new MutablePosture(Stance.POSTURE);
    private boolean standing = true;
    private boolean feetSideBySide = true;
    private int cycle;

    /**
     * Prepares a walk.
     *
     * @param style its numbers
     */
    public WalkEngine(WalkStyle style) {
        this.style = style;
        this.cyclesPerStep = style.gait().stepMillis() / CYCLE_MILLIS;
        this.carriage = Carriage.of(style.gait(), 0);
        this.step = new Step(style.gait());
    }

    /**
     * Says where to walk from now on.
     *
     * @param newVelocity the wanted velocity; it is slowed down to what the robot can do
     */
    public void towards(WalkVelocity newVelocity) {
        towards(newVelocity.forward(), newVelocity.left(), newVelocity.turn());
    }

    /** Says where to walk from now on, as {@link WalkVelocity}. */
    void towards(double forward, double toTheLeft, double turn) {
        wanted.set(forward, toTheLeft, turn);
        wanted.limit(style.most(), style.backward());
    }

    /**
     * Tells whether the robot stands in the stance and does not want to walk.
     *
     * @return whether there is nothing to do
     */
    public boolean isStanding() {
        return standing && wanted.isZero();
    }

    /** The robot stands in the stance, wherever it was before. */
    public void reset() {
        standing = true;
        feetSideBySide = true;
        wanted.set(0, 0, 0);
        velocity.set(0, 0, 0);
        carriage.set(Carriage.of(style.gait(), 0));
        putFeetSideBySide();
        cycle = 0;
        balance.reset();
    }

    /**
     * Feels how the torso moves; to be called in each cycle before {@link #next}.
     *
     * @param torso what gyroscope and accelerometer feel
     */
    public void feel(TorsoMotion torso) {
        balance.feel(torso);
    }

    /**
     * Goes on by one cycle of 20 ms.
     *
     * @return the posture at the end of the cycle; the same object in each cycle
     */
    public MutablePosture next() {
        if (standing && wanted.isZero()) {
            next.set(Stance.POSTURE);
            return next;
        }
        if (cycle == 0) {
            begin();
        }
        cycle++;
        step.setTime((double) cycle / cyclesPerStep);
        keepBalance();
        step.place(walking, kinematics, correction);
        next.setBetween(Stance.POSTURE, walking, smooth(step.vigour()));
        if (cycle == cyclesPerStep) {
            end();
        }
        return next;
    }

    private void begin() {
        if (standing) {
            walking.set(Stance.POSTURE);
            leg = wanted.left() + 0.01 * wanted.turn() >= 0 ? Leg.LEFT : Leg.RIGHT;
        }
        boolean stopping = !standing && wanted.isZero() && velocity.isZero() && feetSideBySide;
        double forwardBefore = velocity.forward();
        changeVelocity();
        double lean = style.gait().leanDegrees()
                + style.leanPerSpeed() * velocity.forward()
                + style.leanPerChange() * (velocity.forward() - forwardBefore);
        double feet = style.gait().feetForward() + style.feetPerSpeed() * velocity.forward();
        step.begin(leg, foot(leg), foot(leg.other()), carriage);
        step.after().set(stopping ? 0 : 1, lean, feet);
        aim(step.target());
    }

    private void changeVelocity() {
        if (standing) {
            velocity.set(0, 0, 0);
        } else {
            velocity.approach(wanted, style.change());
        }
        feetSideBySide = velocity.isZero();
    }

    private MovingPlace foot(Leg which) {
        return which == Leg.LEFT ? left : right;
    }

    /** Finds where the swinging foot comes down as seen from the standing one. */
    private void aim(MovingPlace target) {
        double seconds = style.gait().stepMillis() / 1000.0;
        WalkVelocity slip = style.slip();
        double side = leg == Leg.LEFT ? 1 : -1;
        double open = Math.max(0, 2 * side * slip.left() * velocity.left() * seconds);
        double twist = Math.max(0, 2 * side * slip.turn() * velocity.turn() * seconds);
        target.set(foot(leg.other()));
        target.go(0, side * FootPlace.HALF_WIDTH, side * twist / 2);
        target.go(
                slip.forward() * velocity.forward() * seconds, side * (FootPlace.HALF_WIDTH + open), side * twist / 2);
    }

    private void end() {
        foot(leg).set(step.swinging());
        leg = leg.other();
        carriage.set(step.after());
        standing = carriage.vigour() == 0;
        if (standing) {
            putFeetSideBySide();
        }
        cycle = 0;
    }

    private void putFeetSideBySide() {
        left.set(FootPlace.LEFT);
        right.set(FootPlace.RIGHT);
    }

    private void keepBalance() {
        style.gains()
                .correct(
                        correction,
                        balance.pitchDegrees() - step.leanDegrees(),
                        balance.pitchRate(),
                        balance.rollDegrees() - step.rollDegrees(),
                        balance.rollRate());
    }

    private static double smooth(double part) {
        return part * part * (3 - 2 * part);
    }
}

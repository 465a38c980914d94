package org.robonewbie.agent.walk;

import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.nao.kinematics.InverseKinematics;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;

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
    private WalkVelocity wanted = WalkVelocity.ZERO;
    private WalkVelocity velocity = WalkVelocity.ZERO;
    private FootPlace left = FootPlace.LEFT;
    private FootPlace right = FootPlace.RIGHT;
    private Leg leg = Leg.LEFT;
    private Carriage carriage;
    private Posture last = Stance.POSTURE;
    private Step step;
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
        this.step = nextStep();
    }

    /**
     * Says where to walk from now on.
     *
     * @param newVelocity the wanted velocity; it is slowed down to what the robot can do
     */
    public void towards(WalkVelocity newVelocity) {
        wanted = newVelocity.within(style.most(), style.backward());
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
        wanted = WalkVelocity.ZERO;
        velocity = WalkVelocity.ZERO;
        carriage = Carriage.of(style.gait(), 0);
        left = FootPlace.LEFT;
        right = FootPlace.RIGHT;
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
     * @return the posture at the end of the cycle
     */
    public Posture next() {
        if (standing && wanted.isZero()) {
            return Stance.POSTURE;
        }
        if (cycle == 0) {
            begin();
        }
        cycle++;
        double time = (double) cycle / cyclesPerStep;
        Correction correction = correction(time);
        Posture walking = step.posture(kinematics, last, time, correction);
        last = walking;
        double vigour = step.before().towards(step.after(), time).vigour();
        if (cycle == cyclesPerStep) {
            end(correction);
        }
        return between(Stance.POSTURE, walking, smooth(vigour));
    }

    private void begin() {
        if (standing) {
            last = Stance.POSTURE;
            leg = wanted.left() + 0.01 * wanted.turn() >= 0 ? Leg.LEFT : Leg.RIGHT;
        }
        step = nextStep();
    }

    private Step nextStep() {
        boolean starting = standing;
        WalkVelocity before = velocity;
        velocity = starting ? WalkVelocity.ZERO : velocity.approaching(wanted, style.change());
        boolean stopping = !starting && wanted.isZero() && before.isZero() && feetSideBySide;
        double vigour = stopping ? 0 : 1;
        feetSideBySide = velocity.isZero();
        double lean = style.gait().leanDegrees()
                + style.leanPerSpeed() * velocity.forward()
                + style.leanPerChange() * (velocity.forward() - before.forward());
        double feet = style.gait().feetForward() + style.feetPerSpeed() * velocity.forward();
        Carriage after = new Carriage(vigour, lean, feet);
        FootPlace support = leg == Leg.LEFT ? right : left;
        return new Step(style.gait(), leg, leg == Leg.LEFT ? left : right, target(support), support, carriage, after);
    }

    /** Where the swinging foot comes down as seen from the standing one. */
    private FootPlace target(FootPlace support) {
        double seconds = style.gait().stepMillis() / 1000.0;
        WalkVelocity slip = style.slip();
        double side = leg == Leg.LEFT ? 1 : -1;
        double open = Math.max(0, 2 * side * slip.left() * velocity.left() * seconds);
        double twist = Math.max(0, 2 * side * slip.turn() * velocity.turn() * seconds);
        FootPlace middle = support.then(0, side * FootPlace.HALF_WIDTH, side * twist / 2);
        return middle.then(
                slip.forward() * velocity.forward() * seconds, side * (FootPlace.HALF_WIDTH + open), side * twist / 2);
    }

    private void end(Correction correction) {
        if (leg == Leg.LEFT) {
            left = step.landing(correction);
        } else {
            right = step.landing(correction);
        }
        leg = leg.other();
        carriage = step.after();
        standing = carriage.vigour() == 0;
        if (standing) {
            left = FootPlace.LEFT;
            right = FootPlace.RIGHT;
        }
        cycle = 0;
    }

    private Correction correction(double time) {
        double lean = step.before().towards(step.after(), time).leanDegrees();
        return style.gains()
                .correction(
                        balance.pitchDegrees() - lean,
                        balance.pitchRate(),
                        balance.rollDegrees() - step.rollDegrees(time),
                        balance.rollRate());
    }

    private static double smooth(double part) {
        return part * part * (3 - 2 * part);
    }

    private static Posture between(Posture from, Posture to, double part) {
        if (part == 1) {
            return to;
        }
        double[] degrees = from.toArray();
        double[] end = to.toArray();
        for (int i = 0; i < degrees.length; i++) {
            degrees[i] += part * (end[i] - degrees[i]);
        }
        return Posture.of(degrees);
    }
}

package org.robonewbie.simulator.soccer;

import java.util.Arrays;
import java.util.Optional;
import java.util.Set;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.protocol.monitor.FoulType;

/** State of the foul rules for one player. Times are in ticks of 20 ms. */
final class FoulHistory implements Memory {

    /** Tick in the distant past. */
    static final long NEVER = Long.MIN_VALUE / 2;

    private static final int VELOCITIES = 3;

    private final Vector3[] velocities = new Vector3[VELOCITIES];
    private final long[] frozenUntil;
    private final long[] immuneUntil;
    private Optional<FoulType> punishedFor = Optional.empty();
    private Set<Player> touched = Set.of();
    private int penaltyTicks;
    private int groundTicks;
    private int notStandingTicks;
    private int standingTicks;
    private long movedTick = NEVER;
    private long ballTick = NEVER;
    private long immuneFromChargingTick = NEVER;
    private long areaEntryTick = NEVER;
    private long selfCollisionPenaltyTick = NEVER;
    private int velocityIndex;

    FoulHistory(int hinges) {
        frozenUntil = new long[hinges];
        immuneUntil = new long[hinges];
        forgiveFouls();
        Arrays.fill(velocities, Vector3.ZERO);
    }

    /** Clears penalties and counters, for example during a pause in the match. */
    void forgiveFouls() {
        punishedFor = Optional.empty();
        penaltyTicks = 0;
        groundTicks = 0;
        notStandingTicks = 0;
        standingTicks = 0;
        Arrays.fill(frozenUntil, NEVER);
        Arrays.fill(immuneUntil, NEVER);
    }

    void addVelocity(Vector3 velocity) {
        velocities[velocityIndex] = velocity;
        velocityIndex = (velocityIndex + 1) % VELOCITIES;
    }

    /** Returns the mean horizontal velocity over the last three ticks. */
    Vector3 velocity() {
        Vector3 sum = Vector3.ZERO;
        for (Vector3 velocity : velocities) {
            sum = sum.plus(velocity);
        }
        return new Vector3(sum.x() / VELOCITIES, sum.y() / VELOCITIES, 0);
    }

    boolean isPunished() {
        return punishedFor.isPresent();
    }

    Optional<FoulType> punishedFor() {
        return punishedFor;
    }

    void punish(FoulType foul) {
        punishedFor = Optional.of(foul);
        penaltyTicks = 0;
    }

    /** Counts a tick of the penalty and returns the number of earlier ones. */
    int countPenalty() {
        return penaltyTicks++;
    }

    void countLying(boolean onGround, boolean standing, int ticksUntilStanding) {
        groundTicks = standing ? 0 : groundTicks + (onGround ? 1 : 0);
        notStandingTicks += standing ? 0 : 1;
        standingTicks = standing ? standingTicks + 1 : 0;
        if (standingTicks > ticksUntilStanding) {
            notStandingTicks = 0;
        }
    }

    int groundTicks() {
        return groundTicks;
    }

    int notStandingTicks() {
        return notStandingTicks;
    }

    void moved(long tick) {
        movedTick = tick;
    }

    long movedTick() {
        return movedTick;
    }

    void touchedBall(long tick) {
        ballTick = tick;
    }

    long ballTick() {
        return ballTick;
    }

    /** Grants immunity from charging, as a touch of the ball does. */
    void protectFromCharging(long tick) {
        immuneFromChargingTick = tick;
    }

    long chargingImmunityTick() {
        return Math.max(ballTick, immuneFromChargingTick);
    }

    /** Records whether the player is in its own penalty area. */
    void updateArea(boolean inside, long tick) {
        if (!inside) {
            areaEntryTick = NEVER;
        } else if (areaEntryTick == NEVER) {
            areaEntryTick = tick;
        }
    }

    long areaEntryTick() {
        return areaEntryTick;
    }

    /** Returns the players in the contact group that this player belonged to in the last tick. */
    Set<Player> touched() {
        return touched;
    }

    void setTouched(Set<Player> group) {
        touched = group;
    }

    boolean isFrozen(int hinge, long tick) {
        return tick < frozenUntil[hinge];
    }

    /** Freezes a hinge; returns false if it is already frozen or immune. */
    boolean freeze(int hinge, long tick, long ticksFrozen, long ticksImmune) {
        if (tick < immuneUntil[hinge]) {
            return false;
        }
        frozenUntil[hinge] = tick + ticksFrozen;
        immuneUntil[hinge] = tick + ticksFrozen + ticksImmune;
        return true;
    }

    /** Starts the cooldown of self-collision penalties; returns false if it is still running. */
    boolean startSelfCollisionPenalty(long tick, long cooldownTicks) {
        if (tick - selfCollisionPenaltyTick < cooldownTicks) {
            return false;
        }
        selfCollisionPenaltyTick = tick;
        return true;
    }

    @Override
    public void save(StateWriter out, Roster roster) {
        for (Vector3 velocity : velocities) {
            out.putVector(velocity);
        }
        for (int hinge = 0; hinge < frozenUntil.length; hinge++) {
            out.putLong(frozenUntil[hinge]);
            out.putLong(immuneUntil[hinge]);
        }
        out.putOptional(punishedFor, out::putEnum);
        roster.saveAll(touched, out);
        out.putInt(penaltyTicks);
        out.putInt(groundTicks);
        out.putInt(notStandingTicks);
        out.putInt(standingTicks);
        out.putLong(movedTick);
        out.putLong(ballTick);
        out.putLong(immuneFromChargingTick);
        out.putLong(areaEntryTick);
        out.putLong(selfCollisionPenaltyTick);
        out.putInt(velocityIndex);
    }

    @Override
    public void restore(StateReader in, Roster roster) {
        Arrays.setAll(velocities, i -> in.getVector());
        for (int hinge = 0; hinge < frozenUntil.length; hinge++) {
            frozenUntil[hinge] = in.getLong();
            immuneUntil[hinge] = in.getLong();
        }
        punishedFor = in.getOptional(() -> in.getEnum(FoulType.values()));
        touched = roster.restoreAll(in);
        penaltyTicks = in.getInt();
        groundTicks = in.getInt();
        notStandingTicks = in.getInt();
        standingTicks = in.getInt();
        movedTick = in.getLong();
        ballTick = in.getLong();
        immuneFromChargingTick = in.getLong();
        areaEntryTick = in.getLong();
        selfCollisionPenaltyTick = in.getLong();
        velocityIndex = in.getIndex(VELOCITIES);
    }
}

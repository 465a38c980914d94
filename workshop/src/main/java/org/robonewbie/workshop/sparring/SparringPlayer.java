package org.robonewbie.workshop.sparring;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.skill.Dribble;
import org.robonewbie.team.skill.Footwork;
import org.robonewbie.team.skill.Gaze;
import org.robonewbie.team.skill.GetUp;
import org.robonewbie.team.skill.Goalkeeping;
import org.robonewbie.team.skill.Kick;
import org.robonewbie.team.skill.Limbs;
import org.robonewbie.team.tactics.KickOffPositions;
import org.robonewbie.team.tactics.Plan;
import org.robonewbie.team.tactics.Plan.Action;
import org.robonewbie.team.tactics.Roles;
import org.robonewbie.team.tactics.Strategy;
import org.robonewbie.team.talk.Talk;
import org.robonewbie.team.talk.TeamRole;
import org.robonewbie.team.world.Situation;
import org.robonewbie.team.world.WorldModel;

/**
 * Sparring partner with a single idea of play. {@link FrozenTeam} loads it together with the skills of a fixed version of the
 * example team, so it does not change when the team does.
 */
public final class SparringPlayer extends Agent {

    private static final double STILL_SECONDS = 0.2;
    private static final double BEAM_AGAIN_SECONDS = 1;
    private static final double BEHIND_METRES = 0.45;
    private static final double SEARCH_TURN = 40;
    private static final double MAX_ASIDE_DEGREES = 60;
    private static final int PACK = 3;
    private static final double HELD_METRES = 1;

    private final Idea idea;
    private final WorldModel world = new WorldModel();
    private final Strategy strategy = new Strategy(world);
    private final Limbs body = new Limbs(nao, walk, motions, lookAround);
    private final Footwork feet = new Footwork(walk);
    private final Dribble dribble = new Dribble(walk, feet);
    private final Kick kick = new Kick(body, feet);
    private final GetUp getUp = new GetUp(body);
    private final Goalkeeping keeping = new Goalkeeping(body);
    private final Gaze gaze = new Gaze(body);
    private Plan plan = Plan.NONE;
    private double beamedSeconds = Double.NEGATIVE_INFINITY;

    /** What a sparring partner does differently from the example team. */
    enum Idea {
        /** Kicks the ball towards the opponents' half as soon as it is at the ball, without walking around it. */
        KICKS_AT_ONCE,
        /** The three players nearest to the ball all dribble it. */
        DRIBBLES_IN_A_PACK,
        /** All players stay between the ball and their own goal, and kick the ball away. */
        DEFENDS
    }

    /**
     * Creates a player.
     *
     * @param number player number, 1 to 11
     * @param idea name of an {@link Idea}
     */
    public SparringPlayer(int number, String idea) {
        this.idea = Idea.valueOf(idea);
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
        walk.setStyle(Footwork.STYLE);
    }

    @Override
    protected void think() {
        world.update(nao, fieldView);
        world.listen(nao);
        if (nao.getVision().isPresent()) {
            strategy.decide();
            plan = changed(strategy.plan());
        }
        boolean lineUp = world.situation() == Situation.LINE_UP && world.secondsInSituation() > STILL_SECONDS;
        if (nao.isBeamAllowed() && lineUp) {
            lineUp();
        } else if (nao.isFallen()) {
            getUp.start();
        } else if (motions.isFinished()) {
            play();
        }
        gaze.look(world);
        broadcast();
    }

    private void lineUp() {
        boolean small = !Roles.isKeeper(world, 1);
        Pose2d place = KickOffPositions.place(world.number(), !world.hasScored(), small, world.field());
        boolean away = world.place().distanceTo(place.translation()) > 0.3 || nao.isFallen();
        if (away && world.seconds() - beamedSeconds > BEAM_AGAIN_SECONDS) {
            nao.beam(place.x(), place.y(), place.degrees());
            motions.reset();
            motions.start("stand");
            world.beamed(place);
            beamedSeconds = world.seconds();
        } else {
            walk.stop();
        }
    }

    private Plan changed(Plan usual) {
        boolean open = world.situation().isOpen() && usual.action() != Action.SEARCH && usual.role() != TeamRole.KEEPER;
        if (!open) {
            return usual;
        }
        return switch (idea) {
            case KICKS_AT_ONCE -> usual.role() == TeamRole.STRIKER ? kickAhead() : usual;
            case DRIBBLES_IN_A_PACK -> isInPack() ? dribbleToGoal(usual.role()) : usual;
            case DEFENDS -> usual.role() == TeamRole.STRIKER ? kickAhead() : defend(usual);
        };
    }

    /** Returns a kick in the direction in which the robot comes to the ball, but always towards the opponents' half. */
    private Plan kickAhead() {
        double goal = world.theirGoal().minus(world.ball()).degrees();
        double aside = Angles.wrap(world.ball().minus(world.place()).degrees() - goal);
        double degrees = goal + Math.max(-MAX_ASIDE_DEGREES, Math.min(MAX_ASIDE_DEGREES, aside));
        boolean kicks = plan.action() == Action.KICK && world.place().distanceTo(world.ball()) < HELD_METRES;
        double kept = kicks ? plan.headingDegrees() : degrees;
        return new Plan(
                TeamRole.STRIKER, Action.KICK, world.ball().plus(Translation2d.polar(kept, HELD_METRES)), kept, 0);
    }

    private boolean isInPack() {
        double own = world.place().distanceTo(world.ball());
        return world.mates().stream()
                        .filter(mate -> mate.place().distanceTo(world.ball()) < own)
                        .count()
                < PACK;
    }

    private Plan dribbleToGoal(TeamRole role) {
        return new Plan(role, Action.DRIBBLE, world.theirGoal(), 0, 0);
    }

    /** Returns a place on the arc around the own goal, at a distance from it that depends on the player's number. */
    private Plan defend(Plan usual) {
        Translation2d goal = world.ourGoal();
        int before = (int) world.mates().stream()
                .filter(mate -> mate.number() < world.number())
                .count();
        double out = Math.min(3 + before % 3, world.ball().distanceTo(goal) - 1);
        double aside = (before - world.mates().size() / 2.0) * 0.9;
        Translation2d place = goal.towards(world.ball(), Math.max(1, out)).plus(new Translation2d(0, aside));
        double degrees = world.ball().minus(place).degrees();
        return new Plan(usual.role(), Action.GO, place, degrees, 0);
    }

    private void play() {
        switch (plan.action()) {
            case GO -> feet.go(world, plan.target(), plan.headingDegrees());
            case KEEP -> keep();
            case DRIBBLE -> dribble.bring(world, plan.target());
            case WAIT -> feet.go(world, behindBall(), plan.headingDegrees());
            case KICK, FAR_KICK -> kick.kick(world, plan.headingDegrees());
            case SEARCH -> walk.towards(0, 0, SEARCH_TURN);
            case STAND -> walk.stop();
        }
    }

    private void keep() {
        if (!keeping.dive(world)) {
            feet.go(world, plan.target(), plan.headingDegrees());
        }
    }

    private Translation2d behindBall() {
        return world.ball().plus(Translation2d.polar(plan.headingDegrees(), -BEHIND_METRES));
    }

    private void broadcast() {
        if (Talk.isMyTurn(world.seconds(), world.number())) {
            nao.say(strategy.message(plan).encode());
        }
    }
}

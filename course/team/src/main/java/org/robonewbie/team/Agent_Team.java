package org.robonewbie.team;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.team.skill.Dribble;
import org.robonewbie.team.skill.Footwork;
import org.robonewbie.team.skill.Gaze;
import org.robonewbie.team.skill.GetUp;
import org.robonewbie.team.skill.Goalkeeping;
import org.robonewbie.team.skill.Kick;
import org.robonewbie.team.skill.KickKind;
import org.robonewbie.team.skill.Limbs;
import org.robonewbie.team.tactics.KickOffPositions;
import org.robonewbie.team.tactics.Plan;
import org.robonewbie.team.tactics.Roles;
import org.robonewbie.team.tactics.SetPlay;
import org.robonewbie.team.tactics.Strategy;
import org.robonewbie.team.talk.ShortMessage;
import org.robonewbie.team.talk.Talk;
import org.robonewbie.team.talk.TeamMessage;
import org.robonewbie.team.world.Situation;
import org.robonewbie.team.world.WorldModel;

/**
 * A player of the example team, which plays by the league's rules. In each cycle it updates its world model ({@link
 * WorldModel}), makes a decision ({@link Strategy}), moves (the classes in {@code skill}) and communicates with its teammates
 * ({@link TeamMessage}).
 *
 * <p>{@code Agent_Team 11 --team Blue} starts eleven players with one command, {@code Agent_Team --number 4} only number 4.
 * They play on fields of any size.
 */
public class Agent_Team extends Agent {

    private static final String DEFAULT_PLAYERS = "3";
    private static final String NUMBER = "[1-9]|1[01]";
    private static final int MAX_OF_ONE_TYPE = 7;
    private static final int MAX_OF_TWO_TYPES = 9;
    private static final double STILL_SECONDS = 0.2;
    private static final double BEAM_AGAIN_SECONDS = 1;
    private static final double BEHIND_METRES = 0.45;
    private static final double SEARCH_TURN = 40;
    private static final double KEEPER_TURN = 90;

    private final int number;
    private final WorldModel world = new WorldModel();
    private final Strategy strategy = new Strategy(world);
    private final Limbs body = new Limbs(nao, walk, motions, lookAround);
    private final Footwork feet = new Footwork(walk, true);
    private final Dribble dribble = new Dribble(walk, feet);
    private final Kick kick = new Kick(body, feet);
    private final Kick farKick = new Kick(body, feet, KickKind.FAR);
    private final GetUp getUp = new GetUp(body);
    private final Goalkeeping keeping = new Goalkeeping(body);
    private final Gaze gaze = new Gaze(body);
    private final DecisionDrawing board = new DecisionDrawing(nao, world);
    private List<Translation2d> way = List.of();
    private double beamedSeconds = Double.NEGATIVE_INFINITY;

    /** Creates a player with any free number. */
    public Agent_Team() {
        this(0);
    }

    /**
     * Creates a player.
     *
     * @param number player number, 1 to 11, or 0 for any free number
     */
    public Agent_Team(int number) {
        this.number = number;
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
        walk.setStyle(Footwork.STYLE);
    }

    /**
     * Starts the players.
     *
     * @param args number of players, 1 to 11, and options such as {@code --team Blue}; {@code --number} starts a single player
     */
    public static void main(String[] args) {
        int option = Arrays.asList(args).indexOf("--number");
        Agent[] team = option >= 0
                ? new Agent[] {new Agent_Team(numberAfter(option, args))}
                : IntStream.rangeClosed(1, players(args))
                        .mapToObj(Agent_Team::new)
                        .toArray(Agent[]::new);
        runTogether(args, team);
    }

    /**
     * Returns the robot type of a player. The league allows a team at most seven robots of one type and at most nine of any two
     * types, and requires at least three types among eleven robots.
     *
     * @param number player number, 1 to 11, or 0 for any
     * @return type 0 for the first seven, then two each of types 2 and 4, whose legs are as long as those of type 0
     */
    public static RobotType type(int number) {
        if (number <= MAX_OF_ONE_TYPE) {
            return RobotType.TYPE_0;
        }
        return number <= MAX_OF_TWO_TYPES ? RobotType.TYPE_2 : RobotType.TYPE_4;
    }

    /**
     * Returns the player number that follows an option. Invalid numbers are rejected later, together with the other
     * options.
     */
    private static int numberAfter(int option, String... args) {
        String number = option + 1 < args.length ? args[option + 1] : "";
        return number.matches(NUMBER) ? Integer.parseInt(number) : 0;
    }

    private static int players(String... args) {
        String players = args.length > 0 && !args[0].startsWith("-") ? args[0] : DEFAULT_PLAYERS;
        if (!players.matches(NUMBER)) {
            System.err.println("A team has 1 to 11 players, not \"" + players + "\".");
            System.exit(2);
        }
        return Integer.parseInt(players);
    }

    @Override
    protected Options defaults() {
        return Options.none()
                .withWords()
                .withNumber(number)
                .with("type", Integer.toString(type(number).ordinal()));
    }

    @Override
    protected void think() {
        world.update(nao, fieldView);
        world.listen(nao);
        if (nao.getVision().isPresent()) {
            strategy.decide();
        }
        if (shouldLineUp()) {
            lineUp();
        } else if (nao.isFallen()) {
            getUp();
        } else if (motions.isFinished()) {
            play(strategy.plan());
        }
        gaze.look(world);
        broadcast();
        board.show(strategy.plan(), strategy.options(), way);
    }

    private boolean shouldLineUp() {
        return nao.isBeamAllowed()
                && world.situation() == Situation.LINE_UP
                && world.secondsInSituation() > STILL_SECONDS;
    }

    private void getUp() {
        if (world.abilities().movesLegs()) {
            getUp.start();
        }
    }

    /** Beams the robot to its kick-off position, and again if the referee has moved it. */
    private void lineUp() {
        Pose2d place = KickOffPositions.place(world, !world.hasScored());
        boolean away = world.place().distanceTo(place.translation()) > 0.3 || nao.isFallen();
        boolean free = motions.isFinished() || nao.isFallen();
        if (away && free && world.seconds() - beamedSeconds > BEAM_AGAIN_SECONDS) {
            nao.beam(place.x(), place.y(), place.degrees());
            motions.reset();
            if (world.abilities().movesLegs()) {
                motions.start("stand");
            }
            world.beamed(place);
            beamedSeconds = world.seconds();
        } else if (nao.isFallen()) {
            getUp();
        } else {
            walk.stop();
        }
    }

    private void play(Plan plan) {
        way = List.of(plan.target());
        walk.setStyle(Footwork.STYLE);
        if (SetPlay.wantsPass(world, plan)) {
            nao.requestPass();
        }
        switch (plan.action()) {
            case GO -> way = feet.go(world, plan.target(), plan.headingDegrees());
            case KEEP -> keep(plan);
            case DRIBBLE -> dribble.bring(world, plan.target());
            case WAIT -> way = feet.go(world, behindBall(plan.headingDegrees()), plan.headingDegrees());
            case KICK -> kick.kick(world, plan.headingDegrees());
            case FAR_KICK -> farKick.kick(world, plan.headingDegrees());
            case SEARCH -> walk.towards(0, 0, Roles.keepsAlone(world) ? KEEPER_TURN : SEARCH_TURN);
            case STAND -> walk.stop();
        }
    }

    private Translation2d behindBall(double headingDegrees) {
        return world.ball().plus(Translation2d.polar(headingDegrees, -BEHIND_METRES));
    }

    private void keep(Plan plan) {
        if (world.abilities().movesLegs() && keeping.dive(world)) {
            return;
        }
        if (Goalkeeping.comesOut(world)) {
            feet.shadow(world, plan.target(), plan.headingDegrees());
        } else {
            way = feet.go(world, plan.target(), plan.headingDegrees());
        }
    }

    private void broadcast() {
        if (Talk.isMyTurn(world.seconds(), world.number())) {
            TeamMessage message = strategy.message(strategy.plan());
            nao.say(world.abilities().movesLegs() ? message.encode() : ShortMessage.encode(message, nao.getTeam()));
        }
    }
}

package org.robonewbie.simulator.soccer;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.random.RandomGenerator;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.protocol.monitor.Foul;
import org.robonewbie.simulator.state.JavaUtilRandom;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.RobotContact;
import org.robonewbie.simulator.world.SoccerWorld;

/** State of a soccer match and the operations of the referee. */
public final class Match implements Restorable {

    private static final Set<PlayMode> IN_PLAY = EnumSet.of(PlayMode.PLAY_ON, PlayMode.PASS_LEFT, PlayMode.PASS_RIGHT);

    private final SoccerWorld world;
    private final SoccerParameters parameters;
    private final JavaUtilRandom random;
    private final MatchState state = new MatchState();
    private final Teams teams;
    private final BallTracker ball;
    private final Repositioning repositioning;
    private final PlayModeRules rules;
    private final Referee referee;
    private final KeepawayRule keepaway;
    private final PassMode leftPassMode;
    private final PassMode rightPassMode;
    private final EventLog events = new EventLog();
    private Optional<SetPiece> setPiece = Optional.empty();
    private Optional<TeamSide> nextFirstKickOff;
    private boolean halfBegun;
    private boolean shootout;
    private long tick;

    /**
     * Creates a match before its kick-off.
     *
     * @param world the physical world
     * @param parameters soccer parameters
     * @param seed seed for the referee's random decisions
     */
    public Match(SoccerWorld world, SoccerParameters parameters, long seed) {
        this.world = world;
        this.parameters = parameters;
        this.random = new JavaUtilRandom(seed);
        this.teams = new Teams(parameters);
        this.ball = new BallTracker(world);
        this.repositioning = new Repositioning(this);
        this.rules = new PlayModeRules(this);
        this.referee = new Referee(this);
        this.keepaway = new KeepawayRule(this);
        this.leftPassMode = new PassMode(this, TeamSide.LEFT);
        this.rightPassMode = new PassMode(this, TeamSide.RIGHT);
        this.nextFirstKickOff = presetKickOff();
        this.shootout = parameters.isOn(SoccerParameter.PENALTY_SHOOTOUT);
    }

    /** {@return the clock, the half, the score and the play mode} */
    public MatchState state() {
        return state;
    }

    /** {@return the two teams} */
    public Teams teams() {
        return teams;
    }

    /** {@return the soccer parameters} */
    public SoccerParameters parameters() {
        return parameters;
    }

    /** {@return the events since the last {@link #clearEvents}, in chronological order, unmodifiable} */
    public List<MatchEvent> events() {
        return events.events();
    }

    /** Clears the events. Call after they have been recorded. */
    public void clearEvents() {
        events.clear();
    }

    /** {@return whether robots may be beamed: before a kick-off and after a goal} */
    public boolean mayBeam() {
        return state.playMode() == PlayMode.BEFORE_KICK_OFF
                || state.playMode() == PlayMode.GOAL_LEFT
                || state.playMode() == PlayMode.GOAL_RIGHT;
    }

    /** {@return whether the simulator should exit: ten seconds after the game if {@code AutomaticQuit} is on} */
    public boolean isProgramOver() {
        return state.playMode() == PlayMode.GAME_OVER
                && parameters.isOn(SoccerParameter.AUTOMATIC_QUIT)
                && state.modeSeconds() >= 10;
    }

    /**
     * Changes the play mode.
     *
     * @param playMode the new play mode
     */
    public void setPlayMode(PlayMode playMode) {
        state.setPlayMode(playMode);
        events.add(new MatchEvent.PlayModeChanged(playMode));
        if (!IN_PLAY.contains(playMode)) {
            leftPassMode.unlock();
            rightPassMode.unlock();
        }
        rules.of(playMode).begin();
    }

    /**
     * Starts a kick-off.
     *
     * @param side the team that kicks off
     */
    public void kickOff(TeamSide side) {
        halfBegun = true;
        setPlayMode(side == TeamSide.LEFT ? PlayMode.KICK_OFF_LEFT : PlayMode.KICK_OFF_RIGHT);
    }

    /** Starts a kick-off for the team determined by the rules or by a coin toss. */
    public void kickOff() {
        boolean first = !halfBegun;
        TeamSide side = Optional.<TeamSide>empty()
                .or(() -> first ? nextFirstKickOff : Optional.empty())
                .orElseGet(() -> random.nextBoolean() ? TeamSide.LEFT : TeamSide.RIGHT);
        if (first) {
            boolean swap = parameters.isOn(SoccerParameter.CHANGE_SIDES_IN_SECOND_HALF);
            nextFirstKickOff = Optional.of(swap ? side : side.opponent());
        }
        kickOff(side);
    }

    /** Drops the ball at its current position and moves robots away from it. */
    public void dropBall() {
        dropBall(ball.position());
    }

    /** Resets the score, the clock and the ball, and frees the names of teams without players. */
    public void restart() {
        state.restart();
        teams.removeEmpty();
        events.add(new MatchEvent.PlayModeChanged(PlayMode.BEFORE_KICK_OFF));
        nextFirstKickOff = presetKickOff();
        halfBegun = false;
        setPiece = Optional.empty();
        ball.forgetTouches();
        ball.place(centreSpot());
    }

    /**
     * Replaces a player's robot.
     *
     * @param old the player
     * @param robot the new robot
     * @return the new player with the same team and number
     */
    public Player replaceRobot(Player old, Robot robot) {
        Player replacement = teams.replaceRobot(old, robot);
        ball.replace(old, replacement);
        return replacement;
    }

    /** Advances the match by one cycle of 20 ms. Call after the world's step. */
    public void tick() {
        tick++;
        state.tick(hasRobots());
        ball.update(tick, teams.players());
        checkTime();
        if (state.playMode() != PlayMode.GAME_OVER && keepaway.isGameLost()) {
            setPlayMode(PlayMode.GAME_OVER);
        }
        rules.of(state.playMode()).apply();
        referee.judge(mayBeam());
    }

    /**
     * {@return the latest fouls in chronological order, unmodifiable; a penalty is listed once per cycle of its
     * duration}
     */
    public List<Foul> fouls() {
        return referee.fouls();
    }

    /**
     * Requests pass mode for a player's team. Has no effect unless all conditions for pass mode are met.
     *
     * @param player the requesting player
     */
    public void requestPass(Player player) {
        passMode(player.side()).request(player);
    }

    /**
     * Returns the time until a team may score after its pass mode.
     *
     * @param side the team
     * @return seconds; 0 if it may score
     */
    public double scoreWaitSeconds(TeamSide side) {
        return state.playMode() == PlayMode.PLAY_ON ? passMode(side).lockedSeconds() : 0;
    }

    /**
     * Returns whether the referee has frozen a hinge.
     *
     * @param player the player
     * @param hinge index of the hinge
     * @return whether its motor must not move
     */
    public boolean isFrozen(Player player, int hinge) {
        return player.fouls().isFrozen(hinge, tick);
    }

    /**
     * Places a player beside the pitch.
     *
     * @param player the player
     */
    public void putBesidePitch(Player player) {
        player.robot().moveTo(Spots.besidePitch(this, player).plus(new Vector3(0, 0, 1)));
    }

    /**
     * Moves a player back towards its own goal line.
     *
     * @param player the player
     */
    public void moveTowardsOwnGoal(Player player) {
        double distance = parameters.get(SoccerParameter.FREE_KICK_MOVE_DISTANCE);
        double x = player.side() == TeamSide.LEFT ? -distance : distance;
        player.robot().moveTo(player.position().plus(new Vector3(x, 0, 0)));
    }

    /** Returns whether there are robots, with or without a team. */
    boolean hasRobots() {
        return !world.robots().isEmpty();
    }

    Referee referee() {
        return referee;
    }

    PassMode passMode(TeamSide side) {
        return side == TeamSide.LEFT ? leftPassMode : rightPassMode;
    }

    void addEvent(MatchEvent event) {
        events.add(event);
    }

    List<RobotContact> robotContacts() {
        return world.robotContacts();
    }

    Optional<Player> playerOf(Robot robot) {
        return teams.playerOf(robot);
    }

    Vector3 ballVelocity() {
        return world.ball().velocity();
    }

    SoccerField field() {
        return world.field();
    }

    BallTracker ball() {
        return ball;
    }

    Repositioning repositioning() {
        return repositioning;
    }

    RandomGenerator random() {
        return random;
    }

    long currentTick() {
        return tick;
    }

    List<Player> players() {
        return teams.players();
    }

    List<Player> players(TeamSide side) {
        return teams.team(side).map(Team::players).orElse(List.of());
    }

    /** Returns the position of the ball's centre on the centre spot. */
    Vector3 centreSpot() {
        return new Vector3(0, 0, ball.radius());
    }

    Area penaltyArea(TeamSide side) {
        double halfLength = field().length() / 2;
        double halfWidth = (field().penaltyWidth() + field().goalWidth()) / 2;
        return side == TeamSide.LEFT
                ? new Area(-halfLength, -halfLength + field().penaltyLength(), -halfWidth, halfWidth)
                : new Area(halfLength - field().penaltyLength(), halfLength, -halfWidth, halfWidth);
    }

    Optional<SetPiece> setPiece() {
        return setPiece;
    }

    void setSetPiece(Optional<SetPiece> newSetPiece) {
        setPiece = newSetPiece;
    }

    /**
     * Returns whether the rules for indirect kicks and double touches apply: only in a match with more than two robots.
     */
    boolean hasKickRules() {
        return parameters.isOn(SoccerParameter.FREE_KICK_RULES)
                && !shootout
                && players().size() > 2;
    }

    /** Returns whether this is a penalty shoot-out, which ends with the first goal. */
    boolean isShootout() {
        return shootout;
    }

    void scoreGoal(TeamSide scorer) {
        shootout = false;
        state.addGoal(scorer);
        events.add(new MatchEvent.GoalScored(scorer, teams.name(scorer)));
        setPlayMode(scorer == TeamSide.LEFT ? PlayMode.GOAL_LEFT : PlayMode.GOAL_RIGHT);
    }

    void dropBall(Vector3 position) {
        Vector3 spot = Spots.dropBall(this, position);
        double distance = parameters.get(SoccerParameter.FREE_KICK_DISTANCE);
        double moveDistance = parameters.get(SoccerParameter.FREE_KICK_MOVE_DISTANCE);
        TeamSide first = random.nextBoolean() ? TeamSide.LEFT : TeamSide.RIGHT;
        ball.place(spot);
        repositioning.clearCircle(first, spot, distance, moveDistance);
        repositioning.clearCircle(first.opponent(), spot, distance, moveDistance);
        setPiece = Optional.empty();
        setPlayMode(PlayMode.PLAY_ON);
    }

    private Optional<TeamSide> presetKickOff() {
        return parameters.isOn(SoccerParameter.COIN_TOSS_FOR_KICK_OFF) ? Optional.empty() : Optional.of(TeamSide.LEFT);
    }

    /** Ends a half when its time has elapsed. */
    private void checkTime() {
        double halfTime = parameters.get(SoccerParameter.RULE_HALF_TIME);
        if (state.playMode() == PlayMode.GAME_OVER || state.playSeconds() < state.half() * halfTime) {
            return;
        }
        if (state.half() == 2 || parameters.isOn(SoccerParameter.SINGLE_HALF_TIME)) {
            setPlayMode(PlayMode.GAME_OVER);
        } else {
            beginSecondHalf();
        }
    }

    private void beginSecondHalf() {
        state.setHalf(2);
        halfBegun = false;
        if (parameters.isOn(SoccerParameter.CHANGE_SIDES_IN_SECOND_HALF)) {
            teams.changeSides();
            state.swapScore();
        }
        setPlayMode(PlayMode.BEFORE_KICK_OFF);
    }

    /** Saves the state of the match. The world is saved separately. */
    @Override
    public void save(StateWriter out) {
        teams.save(out, world.robots());
        Roster roster = teams.roster();
        memories().forEach(memory -> memory.save(out, roster));
        random.save(out);
        state.save(out);
        events.save(out);
        out.putOptional(setPiece, piece -> piece.save(out, roster));
        out.putOptional(nextFirstKickOff, out::putEnum);
        out.putBoolean(halfBegun);
        out.putBoolean(shootout);
        out.putLong(tick);
    }

    /** Restores the state. Restore the world first. */
    @Override
    public void restore(StateReader in) {
        teams.restore(in, world.robots());
        Roster roster = teams.roster();
        memories().forEach(memory -> memory.restore(in, roster));
        random.restore(in);
        state.restore(in);
        events.restore(in);
        setPiece = in.getOptional(() -> SetPiece.restore(in, roster));
        nextFirstKickOff = in.getOptional(() -> in.getEnum(TeamSide.values()));
        halfBegun = in.getBoolean();
        shootout = in.getBoolean();
        tick = in.getLong();
    }

    private List<Memory> memories() {
        List<Memory> memories = new ArrayList<>(List.of(ball, rules, referee, leftPassMode, rightPassMode));
        players().forEach(player -> memories.add(player.fouls()));
        return memories;
    }
}

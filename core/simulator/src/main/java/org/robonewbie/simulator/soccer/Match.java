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

/** The game on the pitch: everything that the rules read and change. */
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
     * Prepares a game before its kick-off.
     *
     * @param world the pitch and all that is on it
     * @param parameters the settings
     * @param seed start of the referee's chance
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

    /** {@return the state of the game} */
    public MatchState state() {
        return state;
    }

    /** {@return who plays} */
    public Teams teams() {
        return teams;
    }

    /** {@return the parameters} */
    public SoccerParameters parameters() {
        return parameters;
    }

    /** {@return the events in their order, unmodifiable} */
    public List<MatchEvent> events() {
        return events.events();
    }

    /** Forgets the events; called once they have been recorded. */
    public void clearEvents() {
        events.clear();
    }

    /** {@return whether a robot may be beamed at present: before a kick-off and after a goal} */
    public boolean mayBeam() {
        return state.playMode() == PlayMode.BEFORE_KICK_OFF
                || state.playMode() == PlayMode.GOAL_LEFT
                || state.playMode() == PlayMode.GOAL_RIGHT;
    }

    /** {@return whether the program is to end: some time after the game, if that is wanted} */
    public boolean isProgramOver() {
        return state.playMode() == PlayMode.GAME_OVER
                && parameters.isOn(SoccerParameter.AUTOMATIC_QUIT)
                && state.modeSeconds() >= 10;
    }

    /**
     * Decides something, like a human referee does.
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

    /** Starts a kick-off of the team that the rules or chance determine. */
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

    /** Drops the ball where it lies, and makes room around it. */
    public void dropBall() {
        dropBall(ball.position());
    }

    /** Resets the score, the clock and the ball; the names of teams without players become free. */
    public void restart() {
        state.restart();
        teams.forgetEmpty();
        events.add(new MatchEvent.PlayModeChanged(PlayMode.BEFORE_KICK_OFF));
        nextFirstKickOff = presetKickOff();
        halfBegun = false;
        setPiece = Optional.empty();
        ball.forgetTouches();
        ball.place(centreSpot());
    }

    /**
     * Replaces a player's body.
     *
     * @param old the previous player
     * @param robot its new body
     * @return the player with the same team and number
     */
    public Player replaceRobot(Player old, Robot robot) {
        Player replacement = teams.replaceRobot(old, robot);
        ball.replace(old, replacement);
        return replacement;
    }

    /** Advances the game by one cycle of 20 ms, after the world has moved. */
    public void tick() {
        tick++;
        state.tick(isAnybodyThere());
        ball.update(tick, teams.players());
        checkTime();
        if (state.playMode() != PlayMode.GAME_OVER && keepaway.isGameLost()) {
            setPlayMode(PlayMode.GAME_OVER);
        }
        rules.of(state.playMode()).apply();
        referee.judge(mayBeam());
    }

    /** {@return the newest fouls in their order, unmodifiable; a penalty counts once for each cycle that it takes} */
    public List<Foul> fouls() {
        return referee.fouls();
    }

    /**
     * Asks for the right to pass undisturbed; nothing happens unless all conditions hold.
     *
     * @param player who asks
     */
    public void requestPass(Player player) {
        passMode(player.side()).request(player);
    }

    /**
     * Returns how long a team may not score after it was granted a pass.
     *
     * @param side the team
     * @return seconds, 0 if it may score
     */
    public double scoreWaitSeconds(TeamSide side) {
        return state.playMode() == PlayMode.PLAY_ON ? passMode(side).lockedSeconds() : 0;
    }

    /**
     * Returns whether the referee has frozen a hinge, so that its motor must not move.
     *
     * @param player the player
     * @param hinge index of the hinge
     * @return whether it is frozen
     */
    public boolean isFrozen(Player player, int hinge) {
        return player.fouls().isFrozen(hinge, tick);
    }

    /** Whether there is any robot, with or without a team. */
    boolean isAnybodyThere() {
        return !world.robots().isEmpty();
    }

    Referee referee() {
        return referee;
    }

    PassMode passMode(TeamSide side) {
        return side == TeamSide.LEFT ? leftPassMode : rightPassMode;
    }

    void note(MatchEvent event) {
        events.add(event);
    }

    /** Where robots touched each other in this tick. */
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

    /** The spot in the middle of the pitch, at the height of a lying ball's centre. */
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

    /** Whether the restrictions on kickers apply: in a real game, not for a single robot. */
    boolean hasKickRules() {
        return parameters.isOn(SoccerParameter.FREE_KICK_RULES)
                && !shootout
                && players().size() > 2;
    }

    /** Whether the left team shoots at a lone goalkeeper; it is over with the first goal. */
    boolean isShootout() {
        return shootout;
    }

    void scoreGoal(TeamSide scorer) {
        shootout = false;
        state.addGoal(scorer);
        events.add(new MatchEvent.GoalScored(scorer, teams.name(scorer)));
        setPlayMode(scorer == TeamSide.LEFT ? PlayMode.GOAL_LEFT : PlayMode.GOAL_RIGHT);
    }

    void dropBall(Vector3 place) {
        Vector3 spot = Spots.dropBall(this, place);
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

    /** Ends a half when its time is up. */
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

    /** Writes all that the referee knows; the world is saved apart from it. */
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

    /** Takes on a state after the world has taken on its own. */
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

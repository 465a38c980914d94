package org.robonewbie.team.world;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.robonewbie.agent.Robot;
import org.robonewbie.agent.localisation.SelfLocalisation;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.agent.perception.HeardMessage;
import org.robonewbie.agent.perception.LocalFieldView;
import org.robonewbie.agent.perception.PlayerItem;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.team.talk.ShortMessage;
import org.robonewbie.team.talk.TeamMessage;

/**
 * World model of a player: its pose, the ball, the other robots, and the referee's decisions. All other classes of this team
 * access the game through it, in team coordinates.
 *
 * <p>Information that the player's own sensors have not provided recently is taken from teammates' messages, which contain
 * their poses and ball sightings.
 */
public final class WorldModel {

    private static final double BEAM_SECONDS = 0.15;
    private static final double OWN_EYES_SECONDS = 1;
    private static final double MATE_SECONDS = 4;
    private static final double OPPONENT_SECONDS = 4;
    private static final double LYING_METRES = 0.25;
    private static final double IN_GOAL_METRES = 1;
    private static final double BEGIN_SECONDS = 1;

    /** Maximum tilt of the torso at which sightings are used; sightings are unreliable while the robot is falling. */
    private static final double UPRIGHT_DEGREES = 15;

    private final SelfLocalisation self = new SelfLocalisation();
    private final BallTracker tracker = new BallTracker(false);
    private final BallTracker exactTracker = new BallTracker(true);
    private final HalfTimeDetector sides = new HalfTimeDetector();
    private final SortedMap<Integer, Mate> mates = new TreeMap<>();
    private Pose2d pose = Pose2d.ORIGIN;
    private Translation2d ball = Translation2d.ORIGIN;
    private Translation2d ballVelocity = Translation2d.ORIGIN;
    private double ballSeenSeconds = Double.NEGATIVE_INFINITY;
    private List<Translation2d> opponents = List.of();
    private List<Translation2d> uprightOpponents = List.of();
    private Situation situation = Situation.LINE_UP;
    private double situationSeconds;
    private double lineUpSeconds = Double.NEGATIVE_INFINITY;
    private double beamedSeconds = Double.NEGATIVE_INFINITY;
    private double seconds;
    private int number;
    private RobotType type = RobotType.TYPE_0;
    private Abilities abilities = Abilities.NAO;
    private boolean fallen;
    private boolean scored;
    private boolean placed;
    private boolean begunInGoal;

    /** Creates an empty model. */
    public WorldModel() {}

    /**
     * Processes one cycle. Call this once at the beginning of each cycle.
     *
     * @param nao the robot
     * @param view the robot's field view
     */
    public void update(Robot nao, LocalFieldView view) {
        seconds = nao.getTime();
        number = nao.getNumber();
        type = nao.getType();
        abilities = Abilities.of(nao.getModelName());
        fallen = nao.isFallen();
        if (seconds - beamedSeconds > BEAM_SECONDS) {
            self.update(nao, view);
        }
        boolean upright = self.tiltDegrees() < UPRIGHT_DEGREES && !fallen;
        if (upright && seconds - beamedSeconds > BEAM_SECONDS) {
            tracker.look(self, view.ball(), seconds);
            exactTracker.look(self, view.ball(), seconds);
        }
        sides.look(sides.convert(self.pose()), seconds);
        pose = sides.convert(self.pose());
        detectStartInGoal();
        tracker.roll();
        exactTracker.roll();
        updateSituation(nao);
        mates.values().removeIf(mate -> seconds - mate.heardSeconds() > MATE_SECONDS);
        updateBall();
        if (upright && nao.getVision().isPresent()) {
            opponents = opponents(view.opponents().stream());
            uprightOpponents = opponents(view.opponents().stream().filter(player -> !isLying(player)));
        }
    }

    /** Detects that the robot was placed in its goal, at the start of the program or before a game. */
    private void detectStartInGoal() {
        boolean begins = !placed || seconds - lineUpSeconds < BEGIN_SECONDS;
        if (self.isKnown() && begins) {
            placed = true;
            begunInGoal |= place().distanceTo(ourGoal()) < IN_GOAL_METRES;
        }
    }

    private void updateSituation(Robot nao) {
        TeamSide side = sides.isChanged() ? nao.getTeamSide().opponent() : nao.getTeamSide();
        Situation now = Situation.of(nao.getPlayMode(), side);
        scored = nao.getPlayMode() == (side == TeamSide.LEFT ? PlayMode.GOAL_LEFT : PlayMode.GOAL_RIGHT);
        if (now != situation) {
            lineUpSeconds = situation == Situation.LINE_UP ? seconds : lineUpSeconds;
            situation = now;
            situationSeconds = seconds;
        }
    }

    /** Uses the robot's own estimate of the ball if it is recent, otherwise the latest sighting by a teammate. */
    private void updateBall() {
        BallTracker usual =
                abilities.movesLegs() ? tracker : exactTracker; // no odometry for legs that walk by themselves
        ball = usual.position().onMap(pose);
        ballVelocity = usual.velocity().onMap(new Pose2d(0, 0, pose.degrees()));
        ballSeenSeconds = tracker.seenSeconds();
        if (seconds - ballSeenSeconds > OWN_EYES_SECONDS) {
            Optional<Mate> witness = mates.values().stream()
                    .max(Comparator.comparingDouble(WorldModel::sawBallSeconds))
                    .filter(mate -> mate.message().ballAgeSeconds() < TeamMessage.MAX_AGE_SECONDS)
                    .filter(mate -> sawBallSeconds(mate) > ballSeenSeconds);
            witness.ifPresent(this::adoptBall);
        }
    }

    private static double sawBallSeconds(Mate mate) {
        return mate.heardSeconds() - mate.message().ballAgeSeconds();
    }

    private void adoptBall(Mate witness) {
        Translation2d then = witness.message().ballVelocity();
        double later = seconds - witness.heardSeconds();
        ball = BallFilter.predict(witness.message().ball(), then, later);
        ballVelocity = then.times(Math.max(0, 1 - later / BallFilter.ROLLING_SECONDS));
        ballSeenSeconds = sawBallSeconds(witness);
    }

    private List<Translation2d> opponents(Stream<PlayerItem> players) {
        return players.filter(player -> player.ageSeconds() < OPPONENT_SECONDS)
                .map(player ->
                        Translation2d.of(self.odometry().positionNow(player)).onMap(pose))
                .toList();
    }

    /**
     * Returns whether another robot is lying: its head is far below this robot's own head. Such a robot is an obstacle, but
     * does not play.
     */
    private static boolean isLying(PlayerItem player) {
        FieldItem head = player.part(BodyPart.HEAD);
        boolean seen = head.isKnown() && head.lastSeenSeconds() == player.lastSeenSeconds();
        return seen && head.position().z() < -LYING_METRES;
    }

    /**
     * Processes the messages from teammates. Call this after {@link #update} in each cycle.
     *
     * @param nao the robot
     */
    public void listen(Robot nao) {
        for (HeardMessage heard : nao.getHeard()) {
            if (heard.team().map(nao.getTeam()::equals).orElse(true)) {
                decoded(heard.text(), nao.getTeam()).ifPresent(this::receive);
            }
        }
    }

    private Optional<TeamMessage> decoded(String text, String team) {
        return abilities.movesLegs() ? TeamMessage.decode(text) : ShortMessage.decode(text, team);
    }

    private void receive(TeamMessage message) {
        if (message.number() != number) {
            mates.put(message.number(), new Mate(message, seconds));
        }
    }

    /**
     * Records that the robot has beamed.
     *
     * @param place target pose in team coordinates
     */
    public void beamed(Pose2d place) {
        self.setPose(sides.convert(place));
        sides.beamed(place, seconds);
        tracker.reset();
        exactTracker.reset();
        beamedSeconds = seconds;
        pose = place;
    }

    /** {@return the simulated time in seconds} */
    public double seconds() {
        return seconds;
    }

    /** {@return the robot's player number} */
    public int number() {
        return number;
    }

    /** {@return the robot type} */
    public RobotType type() {
        return type;
    }

    /** {@return what the robot can do} */
    public Abilities abilities() {
        return abilities;
    }

    /** {@return whether the robot is lying on the ground} */
    public boolean isFallen() {
        return fallen;
    }

    /** {@return the state of the game from the team's perspective} */
    public Situation situation() {
        return situation;
    }

    /** {@return seconds since the situation began} */
    public double secondsInSituation() {
        return seconds - situationSeconds;
    }

    /** {@return whether the team has just scored, so the opponents kick off next} */
    public boolean hasScored() {
        return scored;
    }

    /** {@return the field} */
    public SoccerField field() {
        return self.field();
    }

    /** {@return the middle of the opponents' goal line} */
    public Translation2d theirGoal() {
        return new Translation2d(field().length() / 2, 0);
    }

    /** {@return the middle of the team's own goal line} */
    public Translation2d ourGoal() {
        return new Translation2d(-field().length() / 2, 0);
    }

    /** {@return the robot's pose} */
    public Pose2d pose() {
        return pose;
    }

    /** {@return whether the robot was in its goal when it was first localised, or when a game began} */
    public boolean hasBegunInGoal() {
        return begunInGoal;
    }

    /** {@return the robot's position in team coordinates} */
    public Translation2d place() {
        return pose.translation();
    }

    /** {@return the position of the ball} */
    public Translation2d ball() {
        return ball;
    }

    /** {@return the velocity of the ball in metres per second} */
    public Translation2d ballVelocity() {
        return ballVelocity;
    }

    /** {@return seconds since the last sighting of the ball by any player of the team; infinite if there was none} */
    public double ballAgeSeconds() {
        return seconds - ballSeenSeconds;
    }

    /** {@return seconds since the robot's own last sighting of the ball; infinite if there was none} */
    public double ownBallAgeSeconds() {
        return seconds - tracker.seenSeconds();
    }

    /** {@return the position of the ball in the robot's frame} */
    public Translation2d ballFromHere() {
        return ball.seenFrom(pose);
    }

    /**
     * Predicts the position of the ball.
     *
     * @param later seconds from now
     * @return the predicted position
     */
    public Translation2d ballIn(double later) {
        return BallFilter.predict(ball, ballVelocity, later);
    }

    /**
     * Predicts the position of the ball from the robot's own sightings, compensating for the tilt of the torso. Near the
     * feet, this is more precise than {@link #ballIn}.
     *
     * @param later seconds from now
     * @return the predicted position in the robot's frame
     */
    public Translation2d ballAtFeetIn(double later) {
        return BallFilter.predict(exactTracker.position(), exactTracker.velocity(), later);
    }

    /** {@return the teammates with recent messages, by number} */
    public List<Mate> mates() {
        return List.copyOf(mates.values());
    }

    /** {@return whether the team has too few players for a keeper} */
    public boolean isSmallTeam() {
        return mates.size() < abilities.playersWithKeeper() - 1;
    }

    /** {@return the positions of recently seen opponents} */
    public List<Translation2d> opponents() {
        return opponents;
    }

    /**
     * Returns the distance to the nearest upright opponent.
     *
     * @param spot a point
     * @return distance in metres; infinite if no opponent is in sight
     */
    public double opponentDistance(Translation2d spot) {
        return uprightOpponents.stream().mapToDouble(spot::distanceTo).min().orElse(Double.POSITIVE_INFINITY);
    }
}

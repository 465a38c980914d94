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
import org.robonewbie.team.talk.TeamMessage;

/**
 * What a player believes of the game: where it is itself, where the ball rolls, where the others are, and what the referee has
 * decided. Everything else in this team looks at the game through this class, in the coordinates of the team.
 *
 * <p>What the player has not seen itself for a while it takes from its team mates: they say where they are and where they see the
 * ball.
 */
public final class WorldModel {

    private static final double BEAM_SECONDS = 0.15;
    private static final double OWN_EYES_SECONDS = 1;
    private static final double MATE_SECONDS = 4;
    private static final double OPPONENT_SECONDS = 4;
    private static final double LYING_METRES = 0.25;
    private static final double IN_GOAL_METRES = 1;
    private static final double BEGIN_SECONDS = 1;
    private static final int SMALL_TEAM = 8;

    /** A robot that falls sees balls and players where they are not. */
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
    private boolean fallen;
    private boolean scored;
    private boolean placed;
    private boolean begunInGoal;

    /** Creates a model that knows nothing. */
    public WorldModel() {}

    /**
     * Takes in one cycle; call it once in each cycle, first of all.
     *
     * @param nao the robot
     * @param view what it sees
     */
    public void update(Robot nao, LocalFieldView view) {
        seconds = nao.getTime();
        number = nao.getNumber();
        type = nao.getType();
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
        rememberBegin();
        tracker.roll();
        exactTracker.roll();
        updateSituation(nao);
        mates.values().removeIf(mate -> seconds - mate.heardSeconds() > MATE_SECONDS);
        believeBall();
        if (upright && nao.getVision().isPresent()) {
            opponents = opponents(view.opponents().stream());
            uprightOpponents = opponents(view.opponents().stream().filter(player -> !isLying(player)));
        }
    }

    /** Whoever begins in its goal, or is there when a game begins, has been put there. */
    private void rememberBegin() {
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

    /** Believes its own eyes if they have seen the ball lately, else the team mate who has seen it last. */
    private void believeBall() {
        ball = tracker.position().onMap(pose);
        ballVelocity = tracker.velocity().onMap(new Pose2d(0, 0, pose.degrees()));
        ballSeenSeconds = tracker.seenSeconds();
        if (seconds - ballSeenSeconds > OWN_EYES_SECONDS) {
            Optional<Mate> witness = mates.values().stream()
                    .max(Comparator.comparingDouble(WorldModel::sawBallSeconds))
                    .filter(mate -> mate.message().ballAgeSeconds() < TeamMessage.LONGEST_AGE_SECONDS)
                    .filter(mate -> sawBallSeconds(mate) > ballSeenSeconds);
            witness.ifPresent(this::believe);
        }
    }

    private static double sawBallSeconds(Mate mate) {
        return mate.heardSeconds() - mate.message().ballAgeSeconds();
    }

    private void believe(Mate witness) {
        Translation2d then = witness.message().ballVelocity();
        double later = seconds - witness.heardSeconds();
        ball = BallFilter.foresee(witness.message().ball(), then, later);
        ballVelocity = then.times(Math.max(0, 1 - later / BallFilter.ROLLING_SECONDS));
        ballSeenSeconds = sawBallSeconds(witness);
    }

    private List<Translation2d> opponents(Stream<PlayerItem> players) {
        return players.filter(player -> player.ageSeconds() < OPPONENT_SECONDS)
                .map(player ->
                        Translation2d.of(self.odometry().positionNow(player)).onMap(pose))
                .toList();
    }

    /** A robot whose head is far below the own one lies on the ground; it may still be in the way, but it does not play. */
    private static boolean isLying(PlayerItem player) {
        FieldItem head = player.part(BodyPart.HEAD);
        boolean seen = head.isKnown() && head.lastSeenSeconds() == player.lastSeenSeconds();
        return seen && head.position().z() < -LYING_METRES;
    }

    /**
     * Takes in what the team mates say; call it after {@link #update} in each cycle.
     *
     * @param nao the robot
     */
    public void listen(Robot nao) {
        for (HeardMessage heard : nao.getHeard()) {
            if (heard.team().map(nao.getTeam()::equals).orElse(true)) {
                TeamMessage.decode(heard.text()).ifPresent(this::hear);
            }
        }
    }

    private void hear(TeamMessage message) {
        if (message.number() != number) {
            mates.put(message.number(), new Mate(message, seconds));
        }
    }

    /**
     * Remembers that the robot is put somewhere else.
     *
     * @param place where to, in the coordinates of the team
     */
    public void beamed(Pose2d place) {
        self.setPose(sides.convert(place));
        sides.beamed(place, seconds);
        tracker.reset();
        exactTracker.reset();
        beamedSeconds = seconds;
        pose = place;
    }

    /** {@return simulated seconds} */
    public double seconds() {
        return seconds;
    }

    /** {@return the robot's own number} */
    public int number() {
        return number;
    }

    /** {@return how the robot is built} */
    public RobotType type() {
        return type;
    }

    /** {@return whether the robot lies on the ground} */
    public boolean isFallen() {
        return fallen;
    }

    /** {@return what the referee has decided, with the eyes of the team} */
    public Situation situation() {
        return situation;
    }

    /** {@return seconds since the referee has decided so} */
    public double secondsInSituation() {
        return seconds - situationSeconds;
    }

    /** {@return whether the team has just scored, so that the opponents kick off next} */
    public boolean hasScored() {
        return scored;
    }

    /** {@return the pitch} */
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

    /** {@return where the robot is} */
    public Pose2d pose() {
        return pose;
    }

    /** {@return seconds since the robot has seen where it is} */
    public double poseAgeSeconds() {
        return self.ageSeconds();
    }

    /** {@return whether the robot stood in its goal when it first knew where it was, or when a game began} */
    public boolean hasBegunInGoal() {
        return begunInGoal;
    }

    /** {@return the robot's place} */
    public Translation2d place() {
        return pose.translation();
    }

    /** {@return where the ball is} */
    public Translation2d ball() {
        return ball;
    }

    /** {@return how the ball rolls, metres per second} */
    public Translation2d ballVelocity() {
        return ballVelocity;
    }

    /** {@return seconds since somebody of the team has seen the ball; infinite if nobody has} */
    public double ballAgeSeconds() {
        return seconds - ballSeenSeconds;
    }

    /** {@return seconds since the robot itself has seen the ball; infinite if it never has} */
    public double ownBallAgeSeconds() {
        return seconds - tracker.seenSeconds();
    }

    /** {@return where the ball is, seen from the robot} */
    public Translation2d ballFromHere() {
        return ball.seenFrom(pose);
    }

    /**
     * Foresees the ball.
     *
     * @param later how many seconds from now
     * @return where it will be
     */
    public Translation2d ballIn(double later) {
        return BallFilter.foresee(ball, ballVelocity, later);
    }

    /**
     * Foresees the ball as the robot sees it itself, with regard to how the torso leans: for the ball at its feet.
     *
     * @param later how many seconds from now
     * @return where it will be, seen from the robot
     */
    public Translation2d ballAtFeetIn(double later) {
        return BallFilter.foresee(exactTracker.position(), exactTracker.velocity(), later);
    }

    /** {@return the team mates that were heard lately, by their numbers} */
    public List<Mate> mates() {
        return List.copyOf(mates.values());
    }

    /** {@return whether fewer than eight players are there: too few to spare one for the goal} */
    public boolean isSmallTeam() {
        return mates.size() < SMALL_TEAM - 1;
    }

    /** {@return where the opponents are that were seen lately} */
    public List<Translation2d> opponents() {
        return opponents;
    }

    /**
     * Looks how near the opponents are who stand on their feet.
     *
     * @param spot a point
     * @return metres from it to the nearest of them; infinite if none is in sight
     */
    public double opponentDistance(Translation2d spot) {
        return uprightOpponents.stream().mapToDouble(spot::distanceTo).min().orElse(Double.POSITIVE_INFINITY);
    }
}

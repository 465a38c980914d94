package org.robonewbie.agent.perception;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.robonewbie.agent.log.Mistakes;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.perceptor.PolarPosition;
import org.robonewbie.protocol.perceptor.Vision;
import org.robonewbie.protocol.perceptor.Vision.SeenBodyPart;
import org.robonewbie.protocol.perceptor.Vision.SeenLandmark;
import org.robonewbie.protocol.perceptor.Vision.SeenLine;
import org.robonewbie.protocol.perceptor.Vision.SeenPlayer;

/**
 * What the robot remembers of the field around it. The camera sees 120° in each third cycle; here everything stays where it
 * was last seen, as a robot that looks straight ahead would see it.
 *
 * <p>The turns of the head are taken into account, by {@link CameraTransformation#SUM_OF_ANGLES} unless another one is chosen.
 * Other movements of the robot since the last sighting are not: {@link FieldItem#ageSeconds} tells how far to trust.
 *
 * <pre>{@code
 * if (fieldView.ball().isVisible() && fieldView.ball().distance() < 0.5) { ... }
 * }</pre>
 */
public final class LocalFieldView {

    private static final double PLAYER_MEMORY_SECONDS = 10;

    private final Mistakes mistakes;
    private final FieldItem.Vision vision = new FieldItem.Vision();
    private final FieldItem ball;
    private final Map<Landmark, FieldItem> landmarks = new EnumMap<>(Landmark.class);
    /** All robots that were met since the last beam; each keeps its object, whether it is forgotten meanwhile or not. */
    private final List<PlayerItem> met = new ArrayList<>();

    private List<SeenLine> seenLines = List.of();
    private List<LineItem> lines = List.of();
    private String team = "";
    private int number;
    private TeamSide side = TeamSide.LEFT;

    /**
     * Creates a view without memories; the framework does this for each robot.
     *
     * @param mistakes takes questions that have no answer
     */
    public LocalFieldView(Mistakes mistakes) {
        this.mistakes = mistakes;
        ball = new FieldItem("ball", vision, mistakes);
        for (Landmark landmark : Landmark.values()) {
            landmarks.put(landmark, new FieldItem(landmark.toString(), vision, mistakes));
        }
    }

    /**
     * Chooses how the turned head is taken into account.
     *
     * @param transformation such as {@link CameraTransformation#KINEMATICS}
     */
    public void setTransformation(CameraTransformation transformation) {
        vision.transformation = transformation;
    }

    /**
     * Tells the view whose it is, so that the robot does not meet itself.
     *
     * @param ownTeam name of the own team
     * @param ownNumber own number
     * @param ownSide own half of the pitch
     */
    public void setIdentity(String ownTeam, int ownNumber, TeamSide ownSide) {
        team = ownTeam;
        number = ownNumber;
        side = ownSide;
    }

    /**
     * Goes on in time; the framework does this in each cycle.
     *
     * @param seconds simulated time
     */
    public void setTime(double seconds) {
        vision.nowSeconds = seconds;
        if (seconds - vision.pictureSeconds > 0.1) {
            forgetLines();
        }
    }

    /**
     * Takes in a picture of the camera; the framework does this in each cycle that has one, after {@link #setTime}.
     *
     * @param picture what the camera recognises
     * @param neckYawDegrees how far the head is turned
     * @param neckPitchDegrees how far the head is lifted
     */
    public void see(Vision picture, double neckYawDegrees, double neckPitchDegrees) {
        vision.pictureSeconds = vision.nowSeconds;
        vision.yawDegrees = neckYawDegrees;
        vision.pitchDegrees = neckPitchDegrees;
        if (picture.ball().isPresent()) {
            see(ball, picture.ball().get());
        }
        List<SeenLandmark> seenLandmarks = picture.landmarks();
        for (int i = 0;
                i < seenLandmarks.size();
                i++) { // here and below: an iterator for each picture would be garbage
            SeenLandmark seen = seenLandmarks.get(i);
            see(landmark(seen.landmark()), seen.position());
        }
        List<SeenPlayer> seenPlayers = picture.players();
        for (int i = 0; i < seenPlayers.size(); i++) {
            if (!isMyself(seenPlayers.get(i))) {
                see(seenPlayers.get(i));
            }
        }
        forgetLines();
        seenLines = picture.lines();
    }

    /** Forgets everything, since the robot was put somewhere else. */
    public void forget() {
        ball.forget();
        landmarks.values().forEach(FieldItem::forget);
        met.clear();
        forgetLines();
    }

    /**
     * Looks for the ball.
     *
     * @return the ball, known or not
     */
    public FieldItem ball() {
        return ball;
    }

    /**
     * Looks for a goal post or flag by its name on the pitch.
     *
     * @param landmark which one
     * @return the landmark, known or not
     */
    @SuppressWarnings("NullAway") // the map has each landmark
    public FieldItem landmark(Landmark landmark) {
        return landmarks.get(landmark);
    }

    /**
     * Looks for the left post of the goal that the own team attacks.
     *
     * @return the top of the post that is on the left of who looks at that goal from the field
     */
    public FieldItem opponentGoalLeftPost() {
        return landmark(leftPost(side.opponent()));
    }

    /**
     * Looks for the right post of the goal that the own team attacks.
     *
     * @return the top of the post that is on the right of who looks at that goal from the field
     */
    public FieldItem opponentGoalRightPost() {
        return landmark(rightPost(side.opponent()));
    }

    /**
     * Looks for the left post of the goal that the own team defends.
     *
     * @return the top of the post that is on the left of who looks at that goal from the field
     */
    public FieldItem ownGoalLeftPost() {
        return landmark(leftPost(side));
    }

    /**
     * Looks for the right post of the goal that the own team defends.
     *
     * @return the top of the post that is on the right of who looks at that goal from the field
     */
    public FieldItem ownGoalRightPost() {
        return landmark(rightPost(side));
    }

    /**
     * Lists the other robots that were seen within the last 10 seconds.
     *
     * @return team-mates and opponents, in the order in which they were first seen
     */
    public List<PlayerItem> players() {
        return players(player -> true);
    }

    /**
     * Lists the robots of the own team that were seen within the last 10 seconds.
     *
     * @return the team-mates without this robot
     */
    public List<PlayerItem> teamMates() {
        return players(PlayerItem::isTeamMate);
    }

    /**
     * Lists the robots of the other team that were seen within the last 10 seconds.
     *
     * @return the opponents
     */
    public List<PlayerItem> opponents() {
        return players(player -> !player.isTeamMate());
    }

    private List<PlayerItem> players(Predicate<PlayerItem> condition) {
        return met.stream()
                .filter(player -> player.ageSeconds() <= PLAYER_MEMORY_SECONDS)
                .filter(condition)
                .toList();
    }

    /**
     * Lists the field lines of the last picture.
     *
     * @return the visible pieces of lines; empty if the camera has not seen anything for 0.1 s
     */
    public List<LineItem> lines() {
        if (!seenLines.isEmpty()) {
            lines = facingForward(seenLines); // only now, since few robots ask for the many lines
            seenLines = List.of();
        }
        return lines;
    }

    private static Landmark leftPost(TeamSide goal) {
        return goal == TeamSide.RIGHT ? Landmark.GOAL_POST_1_RIGHT : Landmark.GOAL_POST_2_LEFT;
    }

    private static Landmark rightPost(TeamSide goal) {
        return goal == TeamSide.RIGHT ? Landmark.GOAL_POST_2_RIGHT : Landmark.GOAL_POST_1_LEFT;
    }

    private boolean isMyself(SeenPlayer seen) {
        return seen.number() == number && seen.team().equals(team);
    }

    private void see(SeenPlayer seen) {
        PlayerItem player = playerOf(seen);
        boolean hasParts = false;
        List<SeenBodyPart> parts = seen.parts();
        for (int i = 0; i < parts.size(); i++) {
            SeenBodyPart part = parts.get(i);
            hasParts |= see(player.part(part.part()), part.position());
        }
        if (hasParts) {
            player.see();
        } else if (seen.position().isPresent()) {
            see(player, seen.position().get());
        }
        if (player.isKnown() && !met.contains(player)) {
            met.add(player);
        }
    }

    private PlayerItem playerOf(SeenPlayer seen) {
        for (int i = 0; i < met.size(); i++) {
            PlayerItem player = met.get(i);
            if (player.number() == seen.number() && player.team().equals(seen.team())) {
                return player;
            }
        }
        return new PlayerItem(seen.team(), seen.number(), seen.team().equals(team), vision, mistakes);
    }

    private void forgetLines() {
        seenLines = List.of();
        lines = List.of();
    }

    private List<LineItem> facingForward(List<SeenLine> seen) {
        List<LineItem> items = new ArrayList<>(seen.size());
        for (SeenLine line : seen) {
            if (isFinite(line.start()) && isFinite(line.end())) {
                items.add(new LineItem(vision.facingForward(line.start()), vision.facingForward(line.end())));
            }
        }
        return List.copyOf(items);
    }

    private boolean see(FieldItem item, PolarPosition position) {
        if (isFinite(position)) {
            item.see(position);
            return true;
        }
        return false;
    }

    private static boolean isFinite(PolarPosition position) {
        return Double.isFinite(position.distanceMetres() + position.horizontalDegrees() + position.verticalDegrees());
    }
}

package org.robonewbie.agent.perception;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.robonewbie.agent.log.Diagnostics;
import org.robonewbie.nao.FieldMarking;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.perceptor.PolarPosition;
import org.robonewbie.protocol.perceptor.Vision;
import org.robonewbie.protocol.perceptor.Vision.SeenBodyPart;
import org.robonewbie.protocol.perceptor.Vision.SeenLandmark;
import org.robonewbie.protocol.perceptor.Vision.SeenLine;
import org.robonewbie.protocol.perceptor.Vision.SeenMarking;
import org.robonewbie.protocol.perceptor.Vision.SeenPlayer;

/** Implementation of {@link LocalFieldView}, updated by the framework with each camera picture. */
public final class FieldMemory implements LocalFieldView {

    private static final double PLAYER_MEMORY_SECONDS = 10;

    private final Diagnostics diagnostics;
    private final FieldItem.Vision vision = new FieldItem.Vision();
    private final FieldItem ball;
    private final Map<Landmark, FieldItem> landmarks = new EnumMap<>(Landmark.class);
    private final Map<FieldMarking, FieldItem> markings = new EnumMap<>(FieldMarking.class);
    /**
     * All robots that were seen since the last beam. They are kept even if their last sighting is too old for them to
     * be listed.
     */
    private final List<PlayerItem> met = new ArrayList<>();

    private List<SeenLine> seenLines = List.of();
    private List<LineItem> lines = List.of();
    private String team = "";
    private int number;
    private TeamSide side = TeamSide.LEFT;

    /**
     * Creates an empty memory.
     *
     * @param diagnostics receives reports about reads of unknown objects
     */
    public FieldMemory(Diagnostics diagnostics) {
        this.diagnostics = diagnostics;
        ball = new FieldItem("ball", vision, diagnostics);
        for (Landmark landmark : Landmark.values()) {
            landmarks.put(landmark, new FieldItem(landmark.toString(), vision, diagnostics));
        }
        for (FieldMarking marking : FieldMarking.values()) {
            markings.put(marking, new FieldItem(marking.toString(), vision, diagnostics));
        }
    }

    @Override
    public void setTransformation(CameraTransformation transformation) {
        vision.transformation = transformation;
    }

    /**
     * Sets the identity of the robot, so that its own body parts are ignored.
     *
     * @param ownTeam name of the robot's team
     * @param ownNumber the robot's number
     * @param ownSide the half that its team defends
     */
    public void setIdentity(String ownTeam, int ownNumber, TeamSide ownSide) {
        team = ownTeam;
        number = ownNumber;
        side = ownSide;
    }

    /**
     * Sets the clock.
     *
     * @param seconds simulated time in seconds
     */
    public void setTime(double seconds) {
        vision.nowSeconds = seconds;
        if (seconds - vision.pictureSeconds > 0.1) {
            forgetLines();
        }
    }

    /**
     * Adds a camera picture. Call {@link #setTime} first.
     *
     * @param picture the recognised objects
     * @param neckYawDegrees yaw angle of the neck
     * @param neckPitchDegrees pitch angle of the neck
     */
    public void see(Vision picture, double neckYawDegrees, double neckPitchDegrees) {
        vision.pictureSeconds = vision.nowSeconds;
        vision.yawDegrees = neckYawDegrees;
        vision.pitchDegrees = neckPitchDegrees;
        if (picture.ball().isPresent()) {
            see(ball, picture.ball().get());
        }
        for (SeenLandmark seen : picture.landmarks()) {
            see(landmark(seen.landmark()), seen.position());
        }
        for (SeenMarking seen : picture.markings()) {
            see(marking(seen.marking()), seen.position());
        }
        picture.players().stream().filter(seen -> !isMyself(seen)).forEach(this::see);
        forgetLines();
        seenLines = picture.lines();
    }

    /** Clears the memory after the robot has been placed elsewhere. */
    public void forget() {
        ball.forget();
        landmarks.values().forEach(FieldItem::forget);
        markings.values().forEach(FieldItem::forget);
        met.clear();
        forgetLines();
    }

    @Override
    public FieldItem ball() {
        return ball;
    }

    @Override
    @SuppressWarnings("NullAway") // the map contains every landmark
    public FieldItem landmark(Landmark landmark) {
        return landmarks.get(landmark);
    }

    @Override
    @SuppressWarnings("NullAway") // the map contains every marking
    public FieldItem marking(FieldMarking marking) {
        return markings.get(marking);
    }

    @Override
    public FieldItem opponentGoalLeftPost() {
        return landmark(leftPost(side.opponent()));
    }

    @Override
    public FieldItem opponentGoalRightPost() {
        return landmark(rightPost(side.opponent()));
    }

    @Override
    public FieldItem ownGoalLeftPost() {
        return landmark(leftPost(side));
    }

    @Override
    public FieldItem ownGoalRightPost() {
        return landmark(rightPost(side));
    }

    @Override
    public List<PlayerItem> players() {
        return players(player -> true);
    }

    @Override
    public List<PlayerItem> teamMates() {
        return players(PlayerItem::isTeamMate);
    }

    @Override
    public List<PlayerItem> opponents() {
        return players(player -> !player.isTeamMate());
    }

    private List<PlayerItem> players(Predicate<PlayerItem> condition) {
        return met.stream()
                .filter(player -> player.ageSeconds() <= PLAYER_MEMORY_SECONDS)
                .filter(condition)
                .toList();
    }

    @Override
    public List<LineItem> lines() {
        if (!seenLines.isEmpty()) {
            lines = facingForward(seenLines); // computed on demand, because few programs read them
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
        for (SeenBodyPart part : seen.parts()) {
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
        return met.stream()
                .filter(player ->
                        player.number() == seen.number() && player.team().equals(seen.team()))
                .findFirst()
                .orElseGet(() ->
                        new PlayerItem(seen.team(), seen.number(), seen.team().equals(team), vision, diagnostics));
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

package org.robonewbie.exercises;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * Task: kick a ball with a new motion. For odd seeds, the ball lies in front of the left foot; for even seeds, in front
 * of the right one. Neither walking into the ball nor using a built-in kick counts.
 */
final class KickTask implements Task {

    private static final double FAR_METRES = 2;
    private static final double STAYED_METRES = 0.4;
    private static final double TOUCHED_METRES = 0.01;
    private static final double BALL_AHEAD = 0.209;
    private static final double BALL_ASIDE = 0.036;
    private static final double ERROR_METRES = 0.006;

    private final List<RecognisedMotion> given = Stream.of("kick-left", "kick-right")
            .map(ShippedMotions::motion)
            .map(RecognisedMotion::new)
            .toList();

    private Pose2d start = new Pose2d(-3, 0, 0);
    private Vector3 ballStart = Vector3.ZERO;
    private FootBesideBall foot = new FootBesideBall(start, ballStart);
    private double ahead;
    private double left;
    private double metres;
    private double walked;
    private String fall = "";
    private boolean standing;

    @Override
    public Scene scene(RandomSource random) {
        ahead = BALL_AHEAD + random.between(-ERROR_METRES, ERROR_METRES);
        left = (random.isSeedOdd() ? 1 : -1) * BALL_ASIDE + random.between(-ERROR_METRES, ERROR_METRES);
        Pose2d place = new Pose2d(random.between(-4, -1), random.between(-2, 2), random.between(-45, 45));
        return Scene.of(RobotStart.at(place).after("stand")).withBall(5.5, 3.7);
    }

    @Override
    public void begin(Trial trial) {
        start = trial.now().place();
        trial.placeBall(start.pointAt(ahead, left));
        ballStart = trial.ball().position();
        foot = new FootBesideBall(start, ballStart);
    }

    @Override
    public void see(WorldState state) {
        BodyState robot = state.robot();
        given.forEach(motion -> motion.see(robot));
        double direction = PortableMath.toRadians(start.degrees());
        Vector3 way = state.ball().minus(ballStart);
        metres = Math.max(metres, way.x() * PortableMath.cos(direction) + way.y() * PortableMath.sin(direction));
        walked = Math.max(walked, start.distance(robot.position()));
        if (metres < TOUCHED_METRES) {
            foot.see(robot);
        }
        standing = robot.isStanding();
        if (robot.isFallen() && fall.isEmpty()) {
            fall = String.format(Locale.ROOT, " and fell %s after %.1f s", side(robot), state.seconds());
        }
    }

    /** Returns the direction of a fall. */
    private String side(BodyState robot) {
        double bearing = start.bearing(new Vector3(
                start.x() + robot.torso().rotation().apply(new Vector3(0, 0, 1)).x(),
                start.y() + robot.torso().rotation().apply(new Vector3(0, 0, 1)).y(),
                0));
        if (Math.abs(bearing) < 45) {
            return "forward";
        }
        return Math.abs(bearing) > 135 ? "backward" : bearing > 0 ? "to the left" : "to the right";
    }

    @Override
    public Score score() {
        String finding = String.format(
                Locale.ROOT,
                "ball in front of the %s foot: %s, the robot moved %.2f m%s",
                left > 0 ? "left" : "right",
                metres < TOUCHED_METRES ? foot.finding() : String.format(Locale.ROOT, "it went %.2f m", metres),
                walked,
                fall);
        if (given.stream().anyMatch(RecognisedMotion::isRecognised)) {
            return Score.failed(
                    2,
                    finding,
                    "That is one of the framework's kicks. Design your own: its keyframes must differ by"
                            + " more than 4°.");
        }
        if (!fall.isEmpty() || !standing) {
            return Score.failed(
                    Math.min(3, 2 * metres),
                    finding,
                    "Shift the weight onto the other foot before the leg swings; the keyframe in which the robot"
                            + " falls is too fast or goes too far.");
        }
        if (walked > STAYED_METRES) {
            return Score.failed(2, finding, "Kick from where you stand, without walking.");
        }
        return metres >= FAR_METRES
                ? Score.passed(
                        (int) Math.round(7 + metres - FAR_METRES),
                        finding,
                        metres < 5 ? "A kick of 5 m earns 10" + " points." : "")
                : Score.failed(
                        3 * metres,
                        finding,
                        metres < TOUCHED_METRES
                                ? "The foot did not touch the ball. If it stopped short: do the toes scrape the"
                                        + " ground? Raise them by 20°, or bend the knee more. If it was less than 1"
                                        + " cm short, increase the hip pitch. If it passed above the ball, decrease"
                                        + " the hip pitch. If it passed beside it, decrease the hip roll."
                                : "Look down to see which foot the ball is in front of. The foot must be fast when it"
                                        + " hits the ball: use a short keyframe there.");
    }
}

package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.agent.Options;
import org.robonewbie.examples.Agent_BetterSoccer;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.simulator.soccer.SoccerParameter;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.team.Agent_Team;
import org.robonewbie.team.talk.TeamMessage;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.SensorReadings;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.TrialListener;

/**
 * Takes the picture of a pass in {@code docs/team/knowing.md}, from a real match that stops when the ball begins to roll to its receiver.
 */
@Tag("slow")
@InBrowser(width = 960, height = 640)
class TeamPictureTest {

    private static final int PLAYERS = 5;
    private static final long SEED = 1;
    private static final double MAX_SECONDS = 300;
    private static final double MIN_SPEED = 3;
    private static final double READY_METRES = 1.3;
    private static final double ALONE_METRES = 0.9;
    private static final double SHARE_OF_WAY = 0.47;
    private static final int LEFT = 0;
    private static final int WIDTH = 720;
    private static final int HEIGHT = 300;
    private static final String PITCH_ALONE = "for (const each of document.body.querySelectorAll('*'))"
            + " if (!each.querySelector('canvas, .name-tags') && !each.closest('canvas, .name-tags'))"
            + " each.style.visibility = 'hidden'";
    private static final String LABELS = "JSON.stringify(studio.view.drawings.texts.children.map(each => each.name))";

    private final Chromium browser;
    private final MatchOnShow match = new MatchOnShow();

    TeamPictureTest(Chromium browser) {
        this.browser = browser;
    }

    /** A pass: who is to get it, and where to. */
    private record Pass(int receiver, Vector3 end) {}

    @Test
    void passIsOnThePicture() throws IOException {
        browser.drawSharply();
        try (StudioServer studio = StudioServer.start(match, 0, AccessToken.random());
                Trial trial = match.begin(studio.telemetry())) {
            Pass pass = firstPass(trial);
            browser.visit(studio.oneTimeAddress() + "&quality=medium&theme=light");
            browser.await("studio.state.scene.robots.length === " + 2 * PLAYERS + " && studio.state.frame");
            trial.step();
            browser.press("1");
            browser.evaluate(view(trial.now().ball(), pass.end));
            browser.await("studio.camera.isStill");
            trial.step();
            browser.await(LABELS + ".includes('pass to " + pass.receiver + "')");

            browser.evaluate(PITCH_ALONE);
            BufferedImage whole = ImageIO.read(new ByteArrayInputStream(browser.screenshot()));
            BufferedImage part = whole.getSubimage(LEFT, (whole.getHeight() - HEIGHT) / 2, WIDTH, HEIGHT);

            Path file = Picture.ofDocumentation("docs/team/images/studio-pass.png", part);
            assertThat(Files.size(file)).isBetween(10_000L, 200_000L);
        }
    }

    /** Plays until the ball has just left the foot of a player that passes it, and the receiver is ready. */
    private static Pass firstPass(Trial trial) {
        TeamMessage[] said = new TeamMessage[PLAYERS];
        while (trial.seconds() < MAX_SECONDS) {
            trial.step();
            for (int i = 0; i < PLAYERS; i++) {
                int index = i;
                trial.said(i).flatMap(TeamMessage::decode).ifPresent(message -> said[index] = message);
                if (said[i] != null && isPass(trial, i, said[i])) {
                    Vector3 end = new Vector3(
                            said[i].passTarget().x(), said[i].passTarget().y(), 0);
                    return new Pass(said[i].receiver(), end);
                }
            }
        }
        throw new AssertionError("Nobody has passed the ball.");
    }

    private static boolean isPass(Trial trial, int player, TeamMessage said) {
        if (said.receiver() == 0 || trial.now().ballVelocity().length() < MIN_SPEED) {
            return false;
        }
        double rolled = trial.now().place(player).distance(trial.now().ball());
        Vector3 end = new Vector3(said.passTarget().x(), said.passTarget().y(), 0);
        boolean alone = IntStream.range(0, 2 * PLAYERS)
                .filter(other -> other != player)
                .noneMatch(
                        other -> trial.now().place(other).distance(trial.now().ball()) < ALONE_METRES);
        return alone
                && rolled > 0.4
                && rolled < 0.6
                && trial.now().place(said.receiver() - 1).distance(end) < READY_METRES;
    }

    /** Looks at the way of the ball from the side. */
    private static String view(Vector3 ball, Vector3 end) {
        return String.format(
                Locale.ROOT,
                "studio.camera.jumpTo({target: [%.2f, %.2f, 0], azimuthDegrees: %.0f, elevationDegrees: 35, distance: 8.5});"
                        + " studio.touch()",
                ball.x() + SHARE_OF_WAY * (end.x() - ball.x()),
                ball.y() + SHARE_OF_WAY * (end.y() - ball.y()),
                Math.toDegrees(Math.atan2(end.y() - ball.y(), end.x() - ball.x())) - 90);
    }

    /** A match that a studio shows while a test plays it cycle by cycle. */
    private static final class MatchOnShow implements SimulationControl, TrialListener {

        private final List<SimulationObserver> observers = new CopyOnWriteArrayList<>();

        /** Begins to play; what the players think goes to a viewer. */
        Trial begin(TelemetrySink viewer) {
            List<RobotStart> robots = new ArrayList<>();
            for (int i = 0; i < 2 * PLAYERS; i++) {
                int side = i < PLAYERS ? 1 : -1;
                int number = i % PLAYERS + 1;
                Pose2d pose = Options.none().pose(number);
                Pose2d place = new Pose2d(side * pose.x(), side * pose.y(), side > 0 ? 0 : 180);
                String team = side > 0 ? "Team" : "Others";
                robots.add(new RobotStart(team, number, Agent_Team.type(number), place, List.of()));
            }
            SoccerParameters rules = SoccerParameters.league()
                    .with(SoccerParameter.AUTOMATIC_KICK_OFF, 1)
                    .with(SoccerParameter.WAIT_BEFORE_KICK_OFF, 4);
            Trial trial = Trial.observed(
                    new Scene(rules, true, Landscape.SOCCER, robots, Optional.of(Vector3.ZERO)),
                    SEED,
                    this,
                    RecordingTarget.NONE,
                    start -> start.team().equals("Team")
                            ? new ShownPlayer(new Agent_Team(start.number()), viewer)
                            : Controller.ofAgent(new Agent_BetterSoccer()));
            trial.allowBeams();
            trial.order(new Order.SetTime(0));
            trial.order(new Order.ChangePlayMode(PlayMode.BEFORE_KICK_OFF));
            return trial;
        }

        @Override
        public void cycleEnded(Trial trial) {
            observers.forEach(observer -> observer.cycleEnded(trial.snapshot(false, 1)));
        }

        @Override
        public SoccerField field() {
            return SoccerField.LEAGUE;
        }

        @Override
        public void order(Order order) {
            // The test decides what happens.
        }

        @Override
        public void addObserver(SimulationObserver observer) {
            observers.add(observer);
        }

        @Override
        public void removeObserver(SimulationObserver observer) {
            observers.remove(observer);
        }
    }

    /** A player whose drawings can be seen. */
    private static final class ShownPlayer implements Controller {

        private final AgentDriver driver;

        ShownPlayer(Agent agent, TelemetrySink viewer) {
            driver = new AgentDriver(agent);
            driver.publishTo(viewer);
        }

        @Override
        public void introduce(String team, int number, TeamSide side) {
            driver.introduce(Options.none().withTeam(team).withNumber(number), side);
        }

        @Override
        public List<EffectorCommand> respond(SensorReadings readings) {
            return driver.respond(readings.message());
        }
    }
}

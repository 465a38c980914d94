package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.SimulationControl;

class LiveFeedTest {

    private final TestSimulator simulation = new TestSimulator().withRobot();
    private StudioServer studio = open();

    private StudioServer open() {
        try {
            return StudioServer.start(simulation.control(), 0, AccessToken.random());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @AfterEach
    void close() {
        studio.close();
        simulation.close();
    }

    @Test
    void newPageLearnsWhoPlaysBeforeTheFirstFrame() throws InterruptedException {
        try (TestPage page = new TestPage(studio.oneTimeAddress())) {
            JsonObject scene =
                    page.awaitScene(any -> !any.getAsJsonArray("robots").isEmpty());

            assertThat(scene.get("kind").getAsString()).isEqualTo("scene");
            assertThat(scene.getAsJsonObject("field").get("length").getAsDouble())
                    .isEqualTo(12);
            assertThat(scene.getAsJsonObject("teams").get("left").getAsString()).isEqualTo("Blue_Newbies");
            JsonObject robot = scene.getAsJsonArray("robots").get(0).getAsJsonObject();
            assertThat(robot.get("side").getAsString()).isEqualTo("left");
            assertThat(robot.get("number").getAsInt()).isEqualTo(1);
            JsonObject model = scene.getAsJsonObject("models").getAsJsonObject("TYPE_0");
            assertThat(model.getAsJsonArray("links")).hasSize(23);
            assertThat(model.getAsJsonArray("hinges")).hasSize(22);
        }
    }

    @Test
    void framesFollowTheWorld() throws InterruptedException {
        try (TestPage page = new TestPage(studio.oneTimeAddress())) {
            long first = TestPage.cycleOf(page.nextFrame());
            page.seen();
            long second = TestPage.cycleOf(page.nextFrame());

            assertThat(second).isGreaterThan(first);
        }
    }

    @Test
    void notMoreThanAboutTwentyFiveFramesComePerSecond() throws InterruptedException {
        simulation.order(new Order.SetSpeed(SimulationControl.AS_FAST_AS_POSSIBLE));
        long start = System.nanoTime();
        try (TestPage page = new TestPage(studio.oneTimeAddress())) {
            page.nextFrame();
            for (int frame = 0; frame < 21; frame++) {
                page.seen();
                page.nextFrame();
            }

            assertThat(System.nanoTime() - start).isGreaterThan(TimeUnit.MILLISECONDS.toNanos(20 * 30));
        }
    }

    @Test
    void pageThatAnswersLateGetsTheNewestFrame() throws InterruptedException {
        try (TestPage slow = new TestPage(studio.oneTimeAddress())) {
            slow.nextFrame();
            long reached = simulation.afterCycles(20).cycle();
            simulation.afterCycles(1);

            slow.seen();

            assertThat(TestPage.cycleOf(slow.nextFrame())).isGreaterThanOrEqualTo(reached);
        }
    }

    @Test
    void frozenPageDisturbsNeitherTheSimulationNorOthers() throws InterruptedException {
        try (TestPage frozen = new TestPage(studio.oneTimeAddress());
                TestPage lively = new TestPage(studio.oneTimeAddress())) {
            frozen.nextFrame();
            simulation.order(new Order.SetSpeed(SimulationControl.AS_FAST_AS_POSSIBLE));
            long start = simulation.latest().cycle();
            long reached = 0;
            while (reached < start + 200) {
                reached = TestPage.cycleOf(lively.nextFrame());
                lively.seen();
            }

            assertThat(frozen.framesWithin(1)).isFalse();
            assertThat(studio.spectators()).isEqualTo(2);
        }
    }

    @Tag("slow")
    @Test
    void unchangedWorldIsRepeatedOncePerSecond() throws InterruptedException {
        simulation.order(new Order.Pause());
        try (TestPage page = new TestPage(studio.oneTimeAddress())) {
            long paused = page.nextPausedCycle();
            page.nextFrame();
            long start = System.nanoTime();
            page.seen();

            assertThat(TestPage.cycleOf(page.nextFrame())).isEqualTo(paused);
            assertThat(System.nanoTime() - start).isGreaterThan(TimeUnit.MILLISECONDS.toNanos(500));
        }
    }

    @Test
    void robotThatComesLaterChangesTheScene() throws InterruptedException {
        try (TestPage page = new TestPage(studio.oneTimeAddress())) {
            page.nextFrame();
            simulation.withRobot(RobotType.TYPE_4, TeamSide.RIGHT, 7, 2, 1, 180, Posture.STANDING);
            page.seen();

            JsonArray robots = robotsAtLeast(page, 2);

            assertThat(robots.get(1).getAsJsonObject().get("number").getAsInt()).isEqualTo(7);
        }
    }

    private static JsonArray robotsAtLeast(TestPage page, int count) throws InterruptedException {
        return page.awaitScene(scene -> scene.getAsJsonArray("robots").size() >= count)
                .getAsJsonArray("robots");
    }

    @Tag("slow")
    @Test
    void twentyTwoRobotsNeedLessThanSixtyKibibytesPerSecond() throws InterruptedException {
        for (int i = 1; i < 22; i++) {
            TeamSide side = i < 11 ? TeamSide.LEFT : TeamSide.RIGHT;
            simulation.withRobot(RobotType.TYPE_0, side, i % 11 + 1, -5.5 + 0.5 * i, 2, 0, Posture.STANDING);
        }
        try (TestPage page = new TestPage(studio.oneTimeAddress())) {
            page.nextFrame();
            page.seen();
            robotsAtLeast(page, 22);
            ByteBuffer frame = page.nextFrame();
            while (frame.remaining() < 1000) {
                page.seen();
                frame = page.nextFrame();
            }

            assertThat(25 * frame.remaining()).isLessThan(60 * 1024);
        }
    }

    @Test
    void pauseStopsAndResumeContinues() {
        try (TestPage page = new TestPage(studio.oneTimeAddress())) {
            page.send("{\"do\":\"pause\"}");
            await(() -> simulation.latest().paused());
            page.send("{\"do\":\"resume\"}");
            await(() -> !simulation.latest().paused());
        }
    }

    @Test
    void stepRunsSomeCycles() {
        simulation.order(new Order.Pause());
        await(() -> simulation.latest().paused());
        long before = simulation.latest().cycle();
        try (TestPage page = new TestPage(studio.oneTimeAddress())) {
            page.send("{\"do\":\"step\",\"cycles\":3}");

            await(() -> simulation.latest().cycle() == before + 3);
        }
    }

    @Test
    void speedIsSet() {
        try (TestPage page = new TestPage(studio.oneTimeAddress())) {
            page.send("{\"do\":\"speed\",\"factor\":0.25}");
            await(() -> simulation.latest().speed() == 0.25);
            page.send("{\"do\":\"speed\",\"factor\":\"fastest\"}");
            await(() -> simulation.latest().speed() == SimulationControl.AS_FAST_AS_POSSIBLE);
        }
    }

    @Test
    void ballIsPlacedAndResetBringsItBack() {
        try (TestPage page = new TestPage(studio.oneTimeAddress())) {
            page.send("{\"do\":\"placeBall\",\"x\":2,\"y\":-1.5,\"z\":0.042}");
            await(() -> simulation.latest().ballPosition().x() > 1.9);
            page.send("{\"do\":\"reset\"}");
            await(() -> simulation.latest().ballPosition().length() < 0.1);
        }
    }

    @Test
    void robotIsPlaced() {
        try (TestPage page = new TestPage(studio.oneTimeAddress())) {
            page.send("{\"do\":\"placeRobot\",\"side\":\"left\",\"number\":1,\"x\":3,\"y\":2,\"z\":0.4,"
                    + "\"headingDegrees\":90}");

            await(() -> simulation.latest().robots().get(0).body().position().x() > 2.9);
        }
    }

    @ParameterizedTest
    @EnumSource(TeamSide.class)
    void teamKicksOff(TeamSide side) {
        refereeSays(
                "{'do':'kickOff','side':'" + side.name().toLowerCase(Locale.ROOT) + "'}",
                side == TeamSide.LEFT ? PlayMode.KICK_OFF_LEFT : PlayMode.KICK_OFF_RIGHT);
    }

    @Test
    void ballIsDropped() {
        simulation.order(new Order.KickOff(Optional.of(TeamSide.LEFT)));
        await(() -> simulation.latest().playMode() == PlayMode.KICK_OFF_LEFT);

        refereeSays("{'do':'dropBall'}", PlayMode.PLAY_ON);
    }

    @Test
    void playModeIsSetByItsName() {
        refereeSays("{'do':'playMode','mode':'corner_kick_left'}", PlayMode.CORNER_KICK_LEFT);
    }

    private void refereeSays(String command, PlayMode mode) {
        try (TestPage page = new TestPage(studio.oneTimeAddress())) {
            page.send(command.replace('\'', '"'));

            await(() -> simulation.latest().playMode() == mode);
        }
    }

    @Test
    void invalidCommandsAreRefused() throws InterruptedException {
        try (TestPage page = new TestPage(studio.oneTimeAddress())) {
            page.nextFrame();
            page.nextMessage();
            page.send("{\"do\":\"speed\",\"factor\":-1}");

            JsonObject answer = page.nextMessage();
            while (!answer.get("kind").getAsString().equals("refused")) {
                answer = page.nextMessage();
            }

            assertThat(answer.get("text").getAsString())
                    .isEqualTo(
                            "The value -1 for \"factor\" of \"speed\" is out of range. Choose a value from 0.1 to 100.0.");
            page.seen();
            page.nextFrame();
        }
    }

    @Test
    void closedPageIsForgotten() {
        try (TestPage page = new TestPage(studio.oneTimeAddress())) {
            await(() -> studio.spectators() == 1);
            page.seen();
        }

        await(() -> studio.spectators() == 0);
    }

    @Test
    void pagesAreClosedWhenTheSimulatorEnds() throws Exception {
        try (TestPage page = new TestPage(studio.oneTimeAddress())) {
            page.nextFrame();

            studio.close();

            assertThat(page.closeCode()).isEqualTo(1001);
        }
    }

    private void await(BooleanSupplier condition) {
        simulation.awaitTrue(condition);
    }
}

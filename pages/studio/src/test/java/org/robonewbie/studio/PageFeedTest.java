package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.as;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.InstanceOfAssertFactories.STRING;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.embedded.Puppet;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.telemetry.TelemetryItem;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.TrialLabel;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.cycle.SteppedSimulator;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.state.WorldState;

class PageFeedTest {

    private final WorldSettings settings = WorldSettings.beginner();
    private final SteppedSimulator world = SteppedSimulator.start(settings, Console.silent());
    private final AgentLink agent = world.connect();
    private final MessageBuffer message = new MessageBuffer();
    private final List<Order> clock = new ArrayList<>();
    private final List<JsonObject> told = new ArrayList<>();
    private final List<byte[]> frames = new ArrayList<>();
    private final List<String> kept = new ArrayList<>();
    private final PageFeed feed = new PageFeed(new ShownWorld(), new PageFeed.Page() {

        @Override
        public void send(String json) {
            told.add(JsonParser.parseString(json).getAsJsonObject());
        }

        @Override
        public void show(byte[] frame) {
            frames.add(frame);
        }

        @Override
        public void keep(String note) {
            kept.add(note);
        }
    });

    /** A world whose clock only records its orders. */
    private final class ShownWorld implements PageFeed.World {

        @Override
        public WorldSnapshot now() {
            return world.snapshot(false, 1);
        }

        @Override
        public SoccerField field() {
            return settings.parameters().field();
        }

        @Override
        public void order(Order order) {
            if (order instanceof Order.Clock) {
                clock.add(order);
            } else {
                world.order(order);
            }
        }

        @Override
        public Optional<TrialLabel> trial() {
            return feed.trial();
        }

        @Override
        public void save(Consumer<Optional<WorldState>> receiver) {
            receiver.accept(Optional.of(world.save()));
        }

        @Override
        public void restore(WorldState state, Consumer<OptionalInt> receiver) {
            receiver.accept(OptionalInt.of(world.resumeFrom(state)));
        }

        @Override
        public Puppet start(AgentLink link, String team, int number, int type) {
            throw new IllegalStateException("No puppet can join this world.");
        }
    }

    @BeforeEach
    void enter() throws IOException {
        turn("(scene rsg/agent/nao/nao.rsg)(syn)");
        turn("(init (unum 1)(teamname Blue))(syn)");
        turn("(syn)");
    }

    private void turn(String answer) throws IOException {
        message.set(answer.getBytes(StandardCharsets.US_ASCII));
        agent.send(message);
        agent.receive(message);
    }

    private void show() {
        feed.show(world.snapshot(false, 1));
    }

    @Test
    void pageLearnsWhoPlaysBeforeTheFirstFrame() {
        show();

        assertThat(told).extracting(news -> news.get("kind").getAsString()).containsExactly("scene", "undo");
        assertThat(told.get(0).getAsJsonArray("robots")).hasSize(1);
        assertThat(frames).hasSize(1);
    }

    @Test
    void nextFrameWaitsUntilThePageHasSeenTheLastOne() throws IOException {
        show();
        turn("(he1 2)(syn)");

        show();
        assertThat(frames).hasSize(1);
        feed.ask("{\"do\":\"seen\"}");
        show();

        assertThat(frames).hasSize(2);
        assertThat(told).hasSize(2);
    }

    @Test
    void ordersToTheClockGoToItsOwnerAndOthersToTheWorld() throws IOException {
        feed.ask("{\"do\":\"pause\"}");
        feed.ask("{\"do\":\"placeBall\",\"x\":1,\"y\":2,\"z\":0.1}");
        turn("(syn)");

        assertThat(clock).containsExactly(new Order.Pause());
        assertThat(world.snapshot(false, 1)
                        .ballPosition()
                        .minus(new Vector3(1, 2, 0.1))
                        .length())
                .isLessThan(0.05);
    }

    @Test
    void refusedCommandsAreReported() {
        feed.ask("{\"do\":\"walk\",\"side\":\"left\",\"number\":1,\"forward\":1,\"left\":0,\"turn\":0}");
        feed.ask("{\"do\":\"fly\"}");
        show();

        assertThat(sentences())
                .containsExactly(
                        "This robot is controlled by a program. Only puppets can be controlled manually.",
                        "Unknown command \"fly\". Reload the page.");
    }

    @Test
    void changeIsUndoneExactlyAndRedone() {
        feed.ask("{\"do\":\"placeBall\",\"gesture\":7,\"x\":1,\"y\":2,\"z\":0.1}");
        feed.ask("{\"do\":\"placeBall\",\"gesture\":7,\"x\":2,\"y\":2,\"z\":0.1}");
        show();
        assertThat(last("undo").get("undo").getAsString()).isEqualTo("ball moved");

        feed.ask("{\"do\":\"undo\"}");
        assertThat(ball().x()).isZero();
        feed.ask("{\"do\":\"redo\"}");
        feed.ask("{\"do\":\"redo\"}");
        feed.ask("{\"do\":\"seen\"}");
        show();

        assertThat(ball().x()).isEqualTo(2);
        assertThat(sentences())
                .containsExactly("Undone: ball moved.", "Redone: ball moved.", "There is nothing to redo.");
    }

    @Test
    void nothingIsUndoneInATrialThatCounts() {
        feed.judge(new TrialLabel("walk", 1, 1));
        feed.ask("{\"do\":\"placeBall\",\"x\":1,\"y\":2,\"z\":0.1}");
        show();

        assertThat(last("undo").get("undo").getAsString()).isEmpty();
        assertThat(last("scene").get("puppets").getAsBoolean()).isFalse();
    }

    private Vector3 ball() {
        return world.snapshot(false, 1).ballPosition();
    }

    private JsonObject last(String kind) {
        return told.stream()
                .filter(news -> news.get("kind").getAsString().equals(kind))
                .reduce((first, second) -> second)
                .orElseThrow();
    }

    private List<String> sentences() {
        return told.stream()
                .filter(news -> news.get("kind").getAsString().equals("told"))
                .map(news -> news.get("text").getAsString())
                .toList();
    }

    @Test
    void watchedRobotIsSentWithItsHistoryAndMessages() throws IOException {
        feed.accept(new TelemetryMessage("Blue", 1, 0.5, new TelemetryItem.LogEntry("INFO", "hello")));
        feed.ask("{\"do\":\"watch\",\"team\":\"Blue\",\"number\":1}");
        turn("(he1 2)(syn)");
        RobotSnapshot robot = world.snapshot(false, 1).robots().get(0);
        world.messages(id -> id == robot.id()).forEach(messages -> feed.exchanged(robot, messages));
        show();

        JsonObject telemetry = last("telemetry");
        assertThat(feed.watches(robot)).isTrue();
        assertThat(telemetry.getAsJsonArray("lines").toString()).contains("hello");
        assertThat(telemetry.getAsJsonArray("messages").toString()).contains("(he1 2)", "(HJ (n hj1)");
        assertThat(kept).singleElement(as(STRING)).contains("\"robot\":\"Blue 1\"", "\"text\":\"hello\"");
    }

    @Test
    void programErrorIsSentOnce() {
        for (int i = 0; i < 2; i++) {
            feed.accept(new TelemetryMessage("Blue", 1, i, new TelemetryItem.LogEntry("ERROR", "think() failed")));
        }
        show();

        assertThat(told).extracting(news -> news.get("kind").getAsString()).containsExactly("scene", "mistake", "undo");
    }
}

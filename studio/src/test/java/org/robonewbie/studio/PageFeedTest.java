package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.telemetry.TelemetryItem;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.cycle.SteppedSimulator;
import org.robonewbie.simulator.cycle.WorldSettings;

class PageFeedTest {

    private final WorldSettings settings = WorldSettings.beginner();
    private final SteppedSimulator world = SteppedSimulator.start(settings, Console.silent());
    private final AgentLink agent = world.connect();
    private final MessageBuffer message = new MessageBuffer();
    private final List<Order> clock = new ArrayList<>();
    private final List<JsonObject> told = new ArrayList<>();
    private final List<byte[]> frames = new ArrayList<>();
    private final PageFeed feed = new PageFeed(settings.parameters().field(), this::order, new PageFeed.Page() {

        @Override
        public void tell(String json) {
            told.add(JsonParser.parseString(json).getAsJsonObject());
        }

        @Override
        public void show(byte[] frame) {
            frames.add(frame);
        }
    });

    private void order(Order order) {
        if (order instanceof Order.Clock) {
            clock.add(order);
        } else {
            world.order(order);
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

        assertThat(told).extracting(news -> news.get("kind").getAsString()).containsExactly("scene");
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
        assertThat(told).hasSize(1);
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
    void whatIsNotInThePageIsSaid() {
        feed.ask("{\"do\":\"addPuppet\",\"side\":\"left\"}");
        feed.ask("{\"do\":\"fly\"}");
        show();

        assertThat(told.subList(1, 3))
                .extracting(news -> news.get("text").getAsString())
                .containsExactly(
                        "That needs RoboNewbie on your computer: robots steered by hand, and undo, are not in this page yet.",
                        "The studio does not know the command \"fly\". Load the page again.");
    }

    @Test
    void watchedRobotIsHeardFromTheBeginningAndWithItsMessages() throws IOException {
        feed.accept(new TelemetryMessage("Blue", 1, 0.5, new TelemetryItem.LogEntry("INFO", "hello")));
        feed.ask("{\"do\":\"watch\",\"team\":\"Blue\",\"number\":1}");
        turn("(he1 2)(syn)");
        RobotSnapshot robot = world.snapshot(false, 1).robots().get(0);
        world.messages(id -> id == robot.id()).forEach(messages -> feed.exchanged(robot, messages));
        show();

        JsonObject telemetry = told.get(1);
        assertThat(feed.watches(robot)).isTrue();
        assertThat(telemetry.getAsJsonArray("lines").toString()).contains("hello");
        assertThat(telemetry.getAsJsonArray("messages").toString()).contains("(he1 2)", "(HJ (n hj1)");
    }

    @Test
    void mistakeOfAProgramIsToldOnce() {
        for (int i = 0; i < 2; i++) {
            feed.accept(new TelemetryMessage("Blue", 1, i, new TelemetryItem.LogEntry("ERROR", "think() failed")));
        }
        show();

        assertThat(told).extracting(news -> news.get("kind").getAsString()).containsExactly("scene", "mistake");
    }
}

package org.robonewbie.agent;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PolarPosition;
import org.robonewbie.protocol.perceptor.Vision;
import org.robonewbie.protocol.tcp.TelemetryServer;
import org.robonewbie.protocol.telemetry.BelievedThing;
import org.robonewbie.protocol.telemetry.Drawing;
import org.robonewbie.protocol.telemetry.TelemetryItem;
import org.robonewbie.protocol.telemetry.TelemetryItem.Belief;
import org.robonewbie.protocol.telemetry.TelemetryItem.LogEntry;
import org.robonewbie.protocol.telemetry.TelemetryItem.MotionProgress;
import org.robonewbie.protocol.telemetry.TelemetryItem.Picture;
import org.robonewbie.protocol.telemetry.TelemetryItem.PlotValue;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import student.Careless;

class TelemetryOfRobotsTest {

    private final List<TelemetryItem> told = new ArrayList<>();

    @Test
    void tellsLogLinesAtOnce() {
        AgentDriver agent = watched(nao -> nao.log().info("ball at %.1f m", 1.2));

        agent.respond(Messages.standing().build());

        assertThat(told).containsExactly(new LogEntry("INFO", "ball at 1.2 m"));
    }

    @Test
    void tellsMistakesWithTheirLine() {
        AgentDriver agent = watched(Careless::beyondRange);

        agent.respond(Messages.standing().build());

        assertThat(told)
                .singleElement()
                .asString()
                .contains("WARNING")
                .contains("LEFT_KNEE_PITCH is beyond its range")
                .contains("(Careless.java:");
    }

    @Test
    void tellsWhatItBelievesWithEachPicture() {
        AgentDriver agent = watched(new Stander());
        Vision vision = seen(new PolarPosition(2, 90, 0));

        agent.respond(Messages.standing().at(1.00).seeing(vision).build());
        agent.respond(Messages.standing().at(1.02).build());

        assertThat(told.get(0)).isInstanceOfSatisfying(Belief.class, belief -> {
            BelievedThing ball = belief.things().get(0);
            assertThat(ball.name()).isEqualTo("ball");
            assertThat(ball.position().distanceTo(new Vector3(0, 2, 0))).isLessThan(1e-9);
            assertThat(ball.visible()).isTrue();
            assertThat(ball.ageSeconds()).isZero();
        });
    }

    @Test
    void tellsDrawingsOfACycleAsOnePicture() {
        AgentDriver agent = watched(nao -> {
            nao.drawPoint(new Vector3(1, 0, 0), "red");
            nao.drawCircle(Vector3.ZERO, 0.5, "#00ff00");
            nao.drawLine(Vector3.ZERO, new Vector3(1, 0, 0), "blue");
            nao.drawText(Vector3.ZERO, "here", "white");
        });

        agent.respond(Messages.standing().build());

        assertThat(told)
                .containsExactly(new Picture(List.of(
                        new Drawing.Point(new Vector3(1, 0, 0), "red"),
                        new Drawing.Circle(Vector3.ZERO, 0.5, "#00ff00"),
                        new Drawing.Line(Vector3.ZERO, new Vector3(1, 0, 0), "blue"),
                        new Drawing.Text(Vector3.ZERO, "here", "white"))));
    }

    @Test
    void tellsCurvesButNothingThatIsNoNumber() {
        AgentDriver agent = watched(nao -> {
            nao.plot("speed", 0.3);
            nao.plot("nonsense", Double.NaN);
        });

        agent.respond(Messages.standing().build());

        assertThat(told).containsExactly(new PlotValue("speed", 0.3));
    }

    @Test
    void tellsTheMotionWheneverItsKeyframeChanges() {
        AgentDriver stander = watched(new Stander());

        stander.respond(Messages.standing().at(1.00).build());
        stander.respond(Messages.standing().at(1.02).build());

        assertThat(told).containsExactly(new MotionProgress("stand", 1));
    }

    @Test
    void keepsQuietWhileNobodyWatches() {
        Artist artist = new Artist();
        AgentDriver driver = new AgentDriver(artist);

        driver.respond(Messages.standing().build());
        artist.runtime().telemetry().publishTo(this::take);
        driver.respond(Messages.standing().build());

        assertThat(told).hasSize(1);
        assertThat(TelemetrySink.NONE.isWanted()).isFalse();
    }

    @Test
    @Timeout(120)
    void reachesAStudioOfAnotherProcessBesideAnyServer() throws Exception {
        BlockingQueue<TelemetryMessage> heard = new LinkedBlockingQueue<>();
        try (ScriptedServer server = new ScriptedServer(script(200));
                TelemetryServer studio = TelemetryServer.open(TelemetryServer.portFor(server.port()), heard::add)) {
            Nao nao =
                    Nao.connect(Options.none().with("host", "127.0.0.1").with("port", Integer.toString(server.port())));
            Optional<TelemetryMessage> first;
            do {
                nao.log().info("hello studio");
                first = Optional.ofNullable(heard.poll(20, TimeUnit.MILLISECONDS));
            } while (first.isEmpty());
            nao.close();

            assertThat(studio.port()).isPositive();
            assertThat(first)
                    .get()
                    .matches(message -> message.number() == 4 && message.team().equals("RoboNewbie"))
                    .extracting(TelemetryMessage::item)
                    .isEqualTo(new LogEntry("INFO", "hello studio"));
        }
    }

    private AgentDriver watched(Careless.Mistake doing) {
        return watched(new Careless(doing));
    }

    private AgentDriver watched(Agent agent) {
        agent.runtime().telemetry().publishTo(this::take);
        return new AgentDriver(agent);
    }

    private void take(TelemetryMessage message) {
        told.add(message.item());
    }

    private static Vision seen(PolarPosition ball) {
        return Vision.of(List.of(), Optional.of(ball), List.of(), List.of());
    }

    private static List<PerceptorMessage> script(int length) {
        List<PerceptorMessage> script = new ArrayList<>();
        for (int i = 0; i < length; i++) {
            script.add(Messages.standing().at(0.02 * i).build());
        }
        return script;
    }

    /** Plays a motion that comes with the framework. */
    private static final class Stander extends Agent {
        @Override
        protected void think() {
            motions.start("stand");
        }
    }

    /** Draws in each cycle. */
    private static final class Artist extends Agent {
        @Override
        protected void think() {
            nao.drawPoint(Vector3.ZERO, "red");
        }
    }
}

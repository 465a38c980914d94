package org.robonewbie.agent;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PolarPosition;
import org.robonewbie.protocol.perceptor.Vision;
import org.robonewbie.protocol.telemetry.BelievedThing;
import org.robonewbie.protocol.telemetry.Drawing;
import org.robonewbie.protocol.telemetry.TelemetryItem;
import org.robonewbie.protocol.telemetry.TelemetryItem.Belief;
import org.robonewbie.protocol.telemetry.TelemetryItem.LogEntry;
import org.robonewbie.protocol.telemetry.TelemetryItem.MotionProgress;
import org.robonewbie.protocol.telemetry.TelemetryItem.Picture;
import org.robonewbie.protocol.telemetry.TelemetryItem.PlotValue;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.protocol.telemetry.TelemetryServer;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import student.Careless;

class TelemetryOfRobotsTest {

    private final List<TelemetryItem> told = new ArrayList<>();

    @Test
    void tellsLogLinesAtOnce() {
        Careless agent = watched(nao -> nao.log().info("ball at %.1f m", 1.2));

        agent.respond(Messages.standing().build());

        assertThat(told).containsExactly(new LogEntry("INFO", "ball at 1.2 m"));
    }

    @Test
    void tellsMistakesWithTheirLine() {
        Careless agent = watched(Careless::beyondRange);

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
        Stander agent = new Stander();
        agent.watch();
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
        Careless agent = watched(nao -> {
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
        Careless agent = watched(nao -> {
            nao.plot("speed", 0.3);
            nao.plot("nonsense", Double.NaN);
        });

        agent.respond(Messages.standing().build());

        assertThat(told).containsExactly(new PlotValue("speed", 0.3));
    }

    @Test
    void tellsTheMotionWheneverItsKeyframeChanges() {
        Stander stander = new Stander();
        stander.watch();

        stander.respond(Messages.standing().at(1.00).build());
        stander.respond(Messages.standing().at(1.02).build());

        assertThat(told).containsExactly(new MotionProgress("stand", 1));
    }

    @Test
    void keepsQuietWhileNobodyWatches() {
        Artist artist = new Artist();

        artist.respond(Messages.standing().build());
        artist.watch();
        artist.respond(Messages.standing().build());

        assertThat(told).hasSize(1);
        assertThat(TelemetrySink.NONE.isWanted()).isFalse();
    }

    @Test
    void reachesAStudioOfAnotherProcessBesideAnyServer() throws Exception {
        BlockingQueue<TelemetryMessage> heard = new LinkedBlockingQueue<>();
        try (ScriptedServer server = new ScriptedServer(script(200));
                TelemetryServer studio = TelemetryServer.open(TelemetryServer.portFor(server.port()), heard::add)) {
            Nao nao =
                    Nao.connect(Options.none().with("host", "127.0.0.1").with("port", Integer.toString(server.port())));
            long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(10);
            while (!nao.thoughts().isWatched() && System.nanoTime() < end) {
                Thread.onSpinWait();
            }
            nao.log().info("hello studio");
            nao.close();

            assertThat(studio.port()).isPositive();
            assertThat(heard.poll(10, TimeUnit.SECONDS))
                    .matches(message -> message.number() == 4 && message.team().equals("RoboNewbie"))
                    .extracting(TelemetryMessage::item)
                    .isEqualTo(new LogEntry("INFO", "hello studio"));
        }
    }

    private Careless watched(Careless.Mistake doing) {
        return new Careless(nao -> {
            nao.thoughts().tellTo(this::take);
            doing.make(nao);
        });
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

    /** An agent that somebody may watch. */
    private abstract class Watchable extends Agent {
        void watch() {
            nao.thoughts().tellTo(TelemetryOfRobotsTest.this::take);
        }
    }

    /** Plays a motion that comes with the framework. */
    private final class Stander extends Watchable {
        @Override
        protected void think() {
            motions.start("stand");
        }
    }

    /** Draws in each cycle. */
    private final class Artist extends Watchable {
        @Override
        protected void think() {
            nao.drawPoint(Vector3.ZERO, "red");
        }
    }
}

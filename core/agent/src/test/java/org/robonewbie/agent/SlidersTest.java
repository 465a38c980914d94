package org.robonewbie.agent;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robonewbie.protocol.telemetry.TelemetryItem.DeclaredNumber;
import org.robonewbie.protocol.telemetry.TelemetryItem.LogEntry;
import org.robonewbie.protocol.telemetry.TelemetryItem.PlotValue;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.protocol.telemetry.TuningRequest;
import org.robonewbie.protocol.telemetry.TuningRequests;
import student.Tuned;

class SlidersTest {

    private final Viewer viewer = new Viewer();
    private double seconds = 1;

    @Test
    void viewerLearnsTheNumbersBeforeTheFirstThought() {
        cycle(watched(new Tuned()));

        assertThat(viewer.declared)
                .containsEntry("gain", new DeclaredNumber("gain", 0.5, 0, 1, 0.5))
                .containsEntry("near", new DeclaredNumber("near", 0.3, 0.1, 0.8, 0.3));
    }

    @Test
    void sliderChangesFieldsWhatWasComputedFromThemAndObjectsBehindThem() {
        AgentDriver agent = watched(new Tuned());
        cycle(agent);
        cycle(agent);

        viewer.want("gain", 0.8);
        viewer.want("near", 0.4);
        cycle(agent);

        assertThat(viewer.plotted)
                .containsEntry("gain", 0.8)
                .containsEntry("half", 0.4)
                .containsEntry("near", 0.4)
                .containsEntry("cycles", 3.0);
        assertThat(viewer.declared).containsEntry("gain", new DeclaredNumber("gain", 0.5, 0, 1, 0.8));
        assertThat(viewer.log).isEmpty();
    }

    @Test
    void numberThatIsAskedForInEachCycleFollowsItsSlider() {
        AgentDriver agent = watched(new Tuned());
        cycle(agent);

        viewer.want("asked", 7);
        cycle(agent);

        assertThat(viewer.plotted).containsEntry("asked", 7.0).containsEntry("gain", 0.5);
    }

    @Test
    void sliderBeyondTheRangeGivesItsEnd() {
        AgentDriver agent = watched(new Tuned());
        cycle(agent);

        viewer.want("gain", 9);
        cycle(agent);
        assertThat(viewer.plotted).containsEntry("gain", 1.0);

        viewer.want("gain", Double.NaN);
        cycle(agent);
        assertThat(viewer.plotted).containsEntry("gain", 1.0);
    }

    @Test
    void fieldsOfARobotThatCannotBeMadeOnceMoreStayAndTheLogSaysWhatToDo() {
        AgentDriver agent = watched(new Tuned.Named("Ada"));
        cycle(agent);

        viewer.want("gain", 0.8);
        cycle(agent);

        assertThat(viewer.plotted).containsEntry("gain", 0.5).containsEntry("asked", 0.8);
        assertThat(viewer.log).contains("since Named() cannot create a second instance. Call number(...) in think()");
    }

    private AgentDriver watched(Agent agent) {
        AgentDriver driver = new AgentDriver(agent);
        driver.publishTo(viewer);
        return driver;
    }

    private void cycle(AgentDriver agent) {
        seconds += 0.02;
        agent.respond(Messages.standing().at(seconds).build());
    }

    private static final class Viewer implements TelemetrySink {

        private final TuningRequests wishes = new TuningRequests();
        private final Map<String, DeclaredNumber> declared = new HashMap<>();
        private final Map<String, Double> plotted = new HashMap<>();
        private String log = "";
        private String team = "";
        private int number;

        void want(String name, double value) {
            wishes.put(new TuningRequest(team, number, name, value));
        }

        @Override
        public void accept(TelemetryMessage message) {
            team = message.team();
            number = message.number();
            if (message.item() instanceof DeclaredNumber one) {
                declared.put(one.name(), one);
            } else if (message.item() instanceof PlotValue plot) {
                plotted.put(plot.name(), plot.value());
            } else if (message.item() instanceof LogEntry entry) {
                log += entry.text();
            }
        }

        @Override
        public Optional<TuningRequests> tuningRequests() {
            return Optional.of(wishes);
        }
    }
}

package org.robonewbie.simulator.cycle;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.simulator.state.WorldState;

/** An agent that offers its state is saved and restored with its world. */
class SavedAgentTest {

    private final List<String> printed = new ArrayList<>();
    private final SteppedSimulator simulator = SteppedSimulator.start(WorldSettings.league(), printed::add);
    private final AgentLink link = simulator.connect();

    /** Counts, and cannot count beyond 9. */
    private static final class Counter implements Restorable {

        private int count;

        @Override
        public void save(StateWriter out) {
            if (count > 9) {
                throw new IllegalStateException("too many to count");
            }
            out.putInt(count);
        }

        @Override
        public void restore(StateReader in) {
            count = in.getInt();
        }
    }

    @BeforeEach
    void join() throws IOException {
        send("(scene rsg/agent/nao/nao.rsg)(syn)");
        simulator.cycle();
    }

    private void send(String commands) throws IOException {
        MessageBuffer message = new MessageBuffer();
        message.append(commands);
        link.send(message);
    }

    @Test
    void agentIsAsItWas() {
        Counter counter = new Counter();
        link.offerState(counter);
        counter.count = 3;
        WorldState state = simulator.save();
        counter.count = 5;

        simulator.restore(WorldState.ofBytes(state.toBytes()));

        assertThat(counter.count).isEqualTo(3);
    }

    @Test
    void worldGoesOnWithAnAgentThatCannotBeSaved() {
        Counter counter = new Counter();
        link.offerState(counter);
        counter.count = 10;

        simulator.restore(simulator.save());

        assertThat(counter.count).isEqualTo(10);
        assertThat(printed)
                .anyMatch(line -> line.contains("cannot save its state: ") && line.contains("too many to count"))
                .anyMatch(line -> line.contains("cannot restore its saved state: "));
    }

    @Test
    void agentThatOffersNothingKeepsWhatItRemembers() {
        WorldState state = simulator.save();
        Counter counter = new Counter();
        link.offerState(counter);
        counter.count = 5;

        simulator.restore(state);

        assertThat(counter.count).isEqualTo(5);
    }
}

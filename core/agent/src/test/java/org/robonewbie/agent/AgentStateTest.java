package org.robonewbie.agent;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

class AgentStateTest {

    private static class Dancer extends Agent {

        int steps;

        @Override
        protected void think() {
            motions.start("wave");
            steps++;
        }

        boolean isDancing() {
            return !motions.isFinished();
        }
    }

    private static final class SteadyDancer extends Dancer implements Restorable {

        @Override
        public void save(StateWriter out) {
            out.putInt(steps);
        }

        @Override
        public void restore(StateReader in) {
            steps = in.getInt();
        }
    }

    private static void rewind(Dancer dancer) {
        AgentState state = new AgentState(dancer);
        StateWriter saved = new StateWriter();
        state.save(saved);
        dancer.think();
        assertThat(dancer.isDancing()).isTrue();

        StateReader in = new StateReader(saved.toBytes());
        state.restore(in);
        in.finish();
    }

    @Test
    void fieldsOfARestorableAgentAreAsTheyWereAndItsMotionsEnd() {
        SteadyDancer dancer = new SteadyDancer();

        rewind(dancer);

        assertThat(dancer.steps).isZero();
        assertThat(dancer.isDancing()).isFalse();
    }

    @Test
    void anotherAgentRemembersButItsMotionsEnd() {
        Dancer dancer = new Dancer();

        rewind(dancer);

        assertThat(dancer.steps).isEqualTo(1);
        assertThat(dancer.isDancing()).isFalse();
    }
}

package org.robonewbie.programs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.robonewbie.agent.Agent;

class StudentsAgentsTest {

    static class Idle extends Agent {
        @Override
        protected void think() {}
    }

    static final class Failing extends Idle {
        Failing() {
            throw new IllegalStateException("no battery");
        }
    }

    static final class Numbered extends Idle {
        Numbered(int number) {
            System.out.println(number);
        }
    }

    abstract static class Unfinished extends Idle {}

    @Test
    void eachRobotIsANewOne() {
        StudentsAgents agents = new StudentsAgents(() -> Idle.class);

        assertThat(agents.get()).isInstanceOf(Idle.class).isNotSameAs(agents.get());
    }

    @Test
    void classThatMakesNoRobotIsRefused() {
        assertThatThrownBy(() -> new StudentsAgents(() -> String.class))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageStartingWith("An exercise needs a class that extends Agent; String does not.");
        assertThatThrownBy(() -> new StudentsAgents(() -> Numbered.class))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessage("No robot can be created from Numbered: it needs a constructor without parameters.");
    }

    @Test
    void failureOfTheConstructorIsNamed() {
        assertThatThrownBy(new StudentsAgents(() -> Failing.class)::get)
                .hasMessage("its constructor threw java.lang.IllegalStateException: no battery");
        assertThatThrownBy(new StudentsAgents(() -> Unfinished.class)::get).hasMessage("it cannot be created");
    }
}

package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class NearestNameTest {

    private static final List<String> NAMES = List.of("demo", "run", "simulator", "doctor");

    @Test
    void findsTheNameWithTheFewestChanges() {
        assertThat(NearestName.of("docter", NAMES)).contains("doctor");
    }

    @Test
    void takesLargeAndSmallLettersAlike() {
        assertThat(NearestName.of("SIMULATER", NAMES)).contains("simulator");
    }

    @Test
    void prefersANameThatContainsWhatWasWritten() {
        List<String> examples = List.of("Agent_Wave", "Agent_BasicStructure", "Agent_SimpleSoccer");

        assertThat(NearestName.of("Agent_Basic", examples)).contains("Agent_BasicStructure");
        assertThat(NearestName.of("simplesoccer", examples)).contains("Agent_SimpleSoccer");
    }

    @Test
    void findsNothingForSomethingElse() {
        assertThat(NearestName.of("quarterback", NAMES)).isEmpty();
    }

    @Test
    void findsNothingWhereThereIsNothing() {
        assertThat(NearestName.of("demo", List.of())).isEmpty();
    }
}

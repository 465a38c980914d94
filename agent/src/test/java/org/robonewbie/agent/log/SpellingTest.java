package org.robonewbie.agent.log;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class SpellingTest {

    private static final List<String> WORDS = List.of("wave", "walk-forward", "stand");

    @Test
    void findsTheWordThatWasMeant() {
        assertThat(Spelling.nearest("walk-foward", WORDS)).contains("walk-forward");
        assertThat(Spelling.nearest("Wvae", WORDS)).contains("wave");
    }

    @Test
    void guessesNothingFarAway() {
        assertThat(Spelling.nearest("somersault", WORDS)).isEmpty();
    }

    @Test
    void prefersANameThatContainsWhatWasWritten() {
        List<String> examples = List.of("Agent_Wave", "Agent_BasicStructure", "Agent_SimpleSoccer");

        assertThat(Spelling.nearest("Agent_Basic", examples)).contains("Agent_BasicStructure");
        assertThat(Spelling.nearest("simplesoccer", examples)).contains("Agent_SimpleSoccer");
    }

    @Test
    void findsNothingWhereThereIsNothing() {
        assertThat(Spelling.nearest("wave", List.of())).isEmpty();
    }
}

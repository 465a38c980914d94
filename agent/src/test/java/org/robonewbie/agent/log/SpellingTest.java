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
}

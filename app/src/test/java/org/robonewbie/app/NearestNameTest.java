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
    void findsNothingForSomethingElse() {
        assertThat(NearestName.of("quarterback", NAMES)).isEmpty();
    }

    @Test
    void findsNothingWhereThereIsNothing() {
        assertThat(NearestName.of("demo", List.of())).isEmpty();
    }
}

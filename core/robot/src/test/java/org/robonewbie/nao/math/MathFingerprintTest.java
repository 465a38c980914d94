package org.robonewbie.nao.math;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class MathFingerprintTest {

    static Stream<MathFingerprint> fingerprints() {
        return MathFingerprint.all().stream();
    }

    @ParameterizedTest
    @MethodSource("fingerprints")
    void resultsAreTheSameOnEveryMachine(MathFingerprint fingerprint) {
        assertThat(fingerprint.actual())
                .as("%s: %x", fingerprint.function(), fingerprint.actual())
                .isEqualTo(fingerprint.expected());
        assertThat(fingerprint.matches()).isTrue();
    }

    @Test
    void everyFunctionIsChecked() {
        String[] functions = Arrays.stream(PortableMath.class.getDeclaredMethods())
                .filter(method -> !method.isSynthetic())
                .map(Method::getName)
                .toArray(String[]::new);

        assertThat(fingerprints().map(MathFingerprint::function)).containsExactlyInAnyOrder(functions);
    }

    @Test
    void oneUnitInTheLastPlaceOfOneResultIsNoticed() {
        long kept = MathFingerprint.of((x, y) -> PortableMath.sin(x));

        long changed = MathFingerprint.of(
                (x, y) -> x > 0.999 && x < 0.9991 ? Math.nextUp(PortableMath.sin(x)) : PortableMath.sin(x));

        assertThat(changed).isNotEqualTo(kept);
    }
}

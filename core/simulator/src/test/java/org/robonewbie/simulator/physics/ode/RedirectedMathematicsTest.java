package org.robonewbie.simulator.physics.ode;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.ode4j.math.DQuaternion;
import org.ode4j.ode.DRotation;
import org.robonewbie.nao.math.PortableMath;

/** The build redirects ode4j's calls; an IDE that compiles by itself has the unchanged jar. */
@EnabledIfSystemProperty(named = "surefire.real.class.path", matches = ".+")
class RedirectedMathematicsTest {

    private static final String PORTABLE = PortableMath.class.getName().replace('.', '/');

    @ParameterizedTest
    @ValueSource(
            strings = {
                "math/DQuaternion",
                "math/DVector3",
                "ode/internal/Common",
                "ode/internal/Rotation",
                "ode/internal/cpp4j/Cmath",
                "ode/internal/libccd/CCDQuat",
                "ode/internal/libccd/CCDCustomVec3"
            })
    void classThatIsLoadedCallsPortableMathematics(String name) throws IOException {
        try (InputStream file = DQuaternion.class.getResourceAsStream("/org/ode4j/" + name + ".class")) {
            assertThat(file).isNotNull();
            assertThat(new String(file.readAllBytes(), StandardCharsets.ISO_8859_1))
                    .contains(PORTABLE);
        }
    }

    @Test
    void quaternionOfATurnHoldsThePortableSine() {
        assertThat(IntStream.range(1, 10_000).mapToDouble(i -> 0.0003 * i)).allMatch(angle -> {
            DQuaternion turn = new DQuaternion();
            DRotation.dQFromAxisAndAngle(turn, 1, 0, 0, angle);
            return turn.get1() == PortableMath.sin(0.5 * angle);
        });
    }
}

package org.robonewbie.simulator.physics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.robonewbie.simulator.physics.Material.Bounce;

class MaterialTest {

    private static final Material NOTHING =
            new Material(Optional.empty(), OptionalDouble.empty(), OptionalDouble.empty(), OptionalDouble.empty());
    private static final Material FIRM = new Material(
            Optional.of(new Bounce(0.2, 2)), OptionalDouble.of(0.25), OptionalDouble.of(0.5), OptionalDouble.of(0.125));
    private static final Material SOFT = new Material(
            Optional.of(new Bounce(0.4, 1)), OptionalDouble.of(0.75), OptionalDouble.of(1), OptionalDouble.of(0.375));

    @Test
    void takesTheMeanOfWhatBothSidesHave() {
        Material mixed = FIRM.mixedWith(SOFT);

        assertThat(mixed.bounce().orElseThrow().minimumVelocity()).isEqualTo(1.5);
        assertThat(mixed.bounce().orElseThrow().restitution()).isEqualTo((0.2 + 0.4) / 2);
        assertThat(mixed.errorReduction()).hasValue(0.5);
        assertThat(mixed.softness()).hasValue(0.75);
        assertThat(mixed.slip()).hasValue(0.25);
    }

    @Test
    void takesWhatOnlyOneSideHas() {
        assertThat(FIRM.mixedWith(NOTHING)).isEqualTo(FIRM);
        assertThat(NOTHING.mixedWith(SOFT)).isEqualTo(SOFT);
        assertThat(NOTHING.mixedWith(NOTHING)).isEqualTo(NOTHING);
    }
}

package org.robonewbie.workshop.fidelity;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The bars for every recording of a real rcssserver3d that comes with the project. */
class ShippedRecordingsTest {

    private static Map<String, RecordingFidelity> results = Map.of();

    @BeforeAll
    static void replayAll() throws IOException {
        results = FidelityBench.run(AgentRoute.NONE).recordings().stream()
                .collect(Collectors.toMap(RecordingFidelity::name, Function.identity()));
    }

    @Test
    void allSixteenRecordingsAreReplayed() {
        assertThat(results).hasSize(16);
    }

    @Test
    void jointAnglesAgreeToThePrintedDigit() {
        assertThat(results.values())
                .filteredOn(result -> !result.name().startsWith("f_"))
                .allSatisfy(result ->
                        assertThat(result.jointMaxDegrees().orElseThrow()).isLessThan(0.006));
    }

    @Test
    void torsoStaysWithinATenthOfAMillimetre() {
        assertThat(results.values())
                .filteredOn(result -> !result.name().startsWith("f_"))
                .allSatisfy(result -> {
                    assertThat(result.torsoMaxMetres().orElseThrow()).isLessThan(1e-4);
                    assertThat(result.torsoMaxDegrees().orElseThrow()).isLessThan(0.05);
                });
    }

    @Test
    void ballStaysWithinAHundredthOfAMillimetre() {
        assertThat(result("f_ball_nonoise").ballMaxMetres().orElseThrow()).isLessThan(1e-5);
    }

    @Test
    void sensorsPrintTheSameInEveryRowButForRandomReaching() {
        assertThat(results.values())
                .filteredOn(result -> !result.name().startsWith("h_reach"))
                .flatExtracting(ShippedRecordingsTest::sensors)
                .filteredOn(OptionalDouble::isPresent)
                .hasSizeGreaterThan(30)
                .containsOnly(OptionalDouble.of(1));
    }

    @Test
    void sensorsPrintTheSameInNearlyAllRowsOfRandomReaching() {
        assertThat(results.values())
                .filteredOn(result -> result.name().startsWith("h_reach"))
                .hasSize(3)
                .flatExtracting(ShippedRecordingsTest::sensors)
                .allSatisfy(share -> assertThat(share.orElseThrow()).isGreaterThan(0.9));
    }

    @Test
    void nothingDiverges() {
        assertThat(results.values())
                .allSatisfy(
                        result -> assertThat(result.firstDivergenceSeconds()).isEmpty());
    }

    @ParameterizedTest
    @ValueSource(strings = {"b_", "c_", "d_", "h_[ms]", "h_reach_2[13]", "h_reach_22"})
    void pageHasTheLargestDifferencesOfTheGroup(String names) {
        String row = String.format(
                Locale.ROOT,
                "| %.4f° | %.4f mm | %.4f° |",
                largest(names, RecordingFidelity::jointMaxDegrees),
                1000 * largest(names, RecordingFidelity::torsoMaxMetres),
                largest(names, RecordingFidelity::torsoMaxDegrees));

        assertThat(Path.of("..", "docs", "simspark-differences.md")).content().contains(row);
    }

    private static double largest(String names, Function<RecordingFidelity, OptionalDouble> figure) {
        return results.values().stream()
                .filter(result -> result.name().matches(names + ".*"))
                .mapToDouble(result -> figure.apply(result).orElseThrow())
                .max()
                .orElseThrow();
    }

    private static RecordingFidelity result(String name) {
        return Objects.requireNonNull(results.get(name));
    }

    private static List<OptionalDouble> sensors(RecordingFidelity result) {
        return List.of(result.accRowsEqual(), result.gyrRowsEqual(), result.frpRowsEqual());
    }
}

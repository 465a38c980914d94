package org.robonewbie.workshop.fidelity;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

class FidelityReportTest {

    private final FidelityReport report = new FidelityReport(
            List.of(new RecordingFidelity(
                    "squat",
                    OptionalDouble.of(0.001),
                    OptionalDouble.of(0.005),
                    OptionalDouble.of(0.000002),
                    OptionalDouble.of(0.00001),
                    OptionalDouble.of(0.0001),
                    OptionalDouble.empty(),
                    OptionalDouble.of(1),
                    OptionalDouble.of(0.995),
                    OptionalDouble.empty(),
                    OptionalDouble.of(0.000003),
                    OptionalDouble.of(0),
                    OptionalDouble.empty())),
            List.of());

    @Test
    void tableShowsMillimetresAndPercent() {
        String[] lines = report.toTable().split("\n");

        assertThat(lines).hasSize(2);
        assertThat(lines[1].split(" +"))
                .containsExactly(
                        "squat", "0.0010", "0.0050", "0.0020", "0.0100", "0.0001", "-", "100.00", "99.50", "-",
                        "0.0030", "0.0000", "-");
        assertThat(lines[0]).hasSameSizeAs(lines[1]);
    }

    @Test
    void jsonCarriesEveryFieldUnderItsAgreedName() {
        JsonObject recording = JsonParser.parseString(report.toJson())
                .getAsJsonObject()
                .getAsJsonArray("recordings")
                .get(0)
                .getAsJsonObject();

        assertThat(recording.keySet())
                .containsExactly(
                        "name",
                        "jointMedianDegrees",
                        "jointMaxDegrees",
                        "torsoMedianMetres",
                        "torsoMaxMetres",
                        "torsoMaxDegrees",
                        "ballMaxMetres",
                        "accRowsEqual",
                        "gyrRowsEqual",
                        "frpRowsEqual",
                        "restMetres",
                        "restDegrees",
                        "firstDivergenceSeconds");
        assertThat(recording.get("gyrRowsEqual").getAsDouble()).isEqualTo(0.995);
        assertThat(recording.get("firstDivergenceSeconds").isJsonNull()).isTrue();
    }
}

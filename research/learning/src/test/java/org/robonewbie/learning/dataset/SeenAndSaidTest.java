package org.robonewbie.learning.dataset;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Landmark;
import org.robonewbie.protocol.perceptor.FootForces;
import org.robonewbie.protocol.perceptor.Heard;
import org.robonewbie.protocol.perceptor.JointAngles;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PolarPosition;
import org.robonewbie.protocol.perceptor.Vision;

class SeenAndSaidTest {

    @Test
    void eachColumnHasItsCell() {
        Vision picture = Vision.of(
                List.of(new Vision.SeenLandmark(Landmark.FLAG_2_RIGHT, new PolarPosition(5, 10, -3))),
                Optional.empty(),
                List.of(new Vision.SeenPlayer(
                        "Reds",
                        4,
                        List.of(new Vision.SeenBodyPart(BodyPart.HEAD, new PolarPosition(2, -30, 1.5))),
                        Optional.empty())),
                List.of());
        List<Heard> heard = List.of(
                new Heard(Optional.of("Reds"), 3.1, OptionalDouble.of(-20), "ball_me"),
                new Heard(Optional.empty(), 3.1, OptionalDouble.empty(), "own"));

        assertThat(cell("flag_2_right_distance", message(Optional.of(picture), heard)))
                .isEqualTo(5.0);
        assertThat(cell("flag_2_right_vertical", message(Optional.of(picture), heard)))
                .isEqualTo(-3.0);
        assertThat(cell("goal_post_1_left_distance", message(Optional.of(picture), heard)))
                .isEqualTo(Double.NaN);
        assertThat(cell("players", message(Optional.of(picture), heard)))
                .isEqualTo("[{\"team\":\"Reds\",\"number\":4,\"head\":[2.0,-30.0,1.5]}]");
        assertThat(cell("heard", message(Optional.of(picture), heard)))
                .isEqualTo("[{\"team\":\"Reds\",\"direction\":-20.0,\"text\":\"ball_me\"},{\"text\":\"own\"}]");
        assertThat(cell("said", message(Optional.of(picture), heard))).isEqualTo("here");
        assertThat(cell("players", message(Optional.empty(), List.of()))).isEqualTo("");
    }

    private static PerceptorMessage message(Optional<Vision> picture, List<Heard> heard) {
        return new PerceptorMessage(
                OptionalDouble.empty(),
                Optional.empty(),
                heard,
                Optional.empty(),
                Optional.empty(),
                JointAngles.NONE,
                FootForces.NONE,
                picture);
    }

    private static Object cell(String column, PerceptorMessage message) {
        List<Column> columns = new ArrayList<>();
        SeenAndSaid.addColumns(columns);
        List<Object> row = new ArrayList<>();
        SeenAndSaid.put(row, message, "here");
        assertThat(row).hasSameSizeAs(columns);
        return row.get(columns.stream().map(Column::name).toList().indexOf(column));
    }
}

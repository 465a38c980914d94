package org.robonewbie.simulator.sensing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;

class ViewConeTest {

    private final ViewCone cone = new ViewCone(120, 120);

    private Optional<Segment> clip(Segment line) {
        Vector3 start = line.start();
        Vector3 end = line.end();
        double[] ends = {start.x(), start.y(), start.z(), end.x(), end.y(), end.z()};
        return cone.clip(ends)
                ? Optional.of(
                        new Segment(new Vector3(ends[0], ends[1], ends[2]), new Vector3(ends[3], ends[4], ends[5])))
                : Optional.empty();
    }

    @Test
    void aLineWithTwoVisibleEndsStaysAsItIs() {
        Segment line = new Segment(new Vector3(-1, 2, 0), new Vector3(1, 3, 1));

        assertThat(clip(line)).contains(line);
    }

    @Test
    void theHiddenEndIsCutAtTheEdge() {
        Vector3 seen = new Vector3(0, 2, 0);

        Segment cut = clip(new Segment(seen, new Vector3(10, 2, 0))).orElseThrow();

        assertThat(cut.start()).isEqualTo(seen);
        assertThat(cut.end().x()).isCloseTo(2 * Math.tan(Math.PI / 3), within(1e-12));
        assertThat(cut.end().y()).isCloseTo(2, within(1e-12));
    }

    @Test
    void theOrderOfTheEndsIsKeptWhenOneIsHidden() {
        Vector3 seen = new Vector3(0, 2, 0);

        Segment cut = clip(new Segment(new Vector3(10, 2, 0), seen)).orElseThrow();

        assertThat(cut.end()).isEqualTo(seen);
    }

    @Test
    void aLineThatCrossesThePictureIsCutLeftAndRight() {
        Segment cut = clip(new Segment(new Vector3(10, 2, -0.5), new Vector3(-10, 2, -0.5)))
                .orElseThrow();

        assertThat(cut.start().x()).isNegative();
        assertThat(cut.end().x()).isPositive();
    }

    @Test
    void aLineBehindTheCameraIsNotSeen() {
        assertThat(clip(new Segment(new Vector3(10, -2, 0), new Vector3(-10, -2, 0))))
                .isEmpty();
    }

    @Test
    void aLineThatPassesTheCornerOfThePictureOutsideIsNotSeen() {
        assertThat(clip(new Segment(new Vector3(3, 1, -9), new Vector3(9, 1, -3))))
                .isEmpty();
    }

    @Test
    void aLineUnderTheCameraBeginsAtTheLowerEdge() {
        Segment cut = clip(new Segment(new Vector3(0, -5, -0.5), new Vector3(0, 5, -0.5)))
                .orElseThrow();

        assertThat(cut.start().z() / cut.start().y()).isCloseTo(-Math.tan(Math.PI / 3), within(1e-12));
        assertThat(cut.end().y()).isEqualTo(5);
    }
}

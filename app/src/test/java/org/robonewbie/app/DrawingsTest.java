package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Joint;

/** Drawings of the documentation. */
class DrawingsTest {

    @Test
    void everyJointIsInThePictureWithItsRange() {
        String picture = Project.read(Project.ROOT.resolve("docs/images/joints.svg"));

        assertThat(Joint.values())
                .allSatisfy(joint -> assertThat(picture)
                        .contains(">" + joint + "<")
                        .contains(String.format(
                                "%.0f° to %.0f°  (%s)", joint.minDegrees(), joint.maxDegrees(), joint.standardName())));
    }

    @Test
    void drawingsHaveTheirOwnGroundInLightAndDark() {
        List<String> drawings = List.of(
                "architecture",
                "camera",
                "field",
                "joints",
                "keyframes",
                "message-cycle",
                "pendulum",
                "sense-think-act");

        assertThat(drawings)
                .map(name -> Project.read(Project.ROOT.resolve("docs/images/" + name + ".svg")))
                .allMatch(picture -> picture.contains("class=\"bg\"") && picture.contains("prefers-color-scheme:dark"));
    }
}

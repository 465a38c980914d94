package org.robonewbie.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Runs each example in the simulator, as fast as it can, and looks at the true results. */
class ExamplesTest {

    @TempDir
    private Path folder;

    @Test
    void basicStructureRaisesTheLeftArmTo30Degrees() throws Exception {
        Agent_BasicStructure.main(fast("12"));

        assertThat(reported("LEFT_SHOULDER_PITCH")).isCloseTo(30, within(2.5));
        assertThat(reported("simulatedSeconds")).isEqualTo(12);
    }

    @Test
    void waveEndsByItselfWithTheRobotOnItsFeet() throws Exception {
        Agent_Wave.main(fast("60"));

        assertThat(reported("simulatedSeconds")).isBetween(2.0, 10.0);
        assertThat(reported("falls")).isZero();
    }

    @Test
    void simpleSoccerReachesTheBallAndPushesIt() throws Exception {
        Agent_SimpleSoccer.main(fast("240"));

        assertThat(reported("metresMoved")).isGreaterThan(0.3);
    }

    private String[] fast(String seconds) {
        return new String[] {
            "--headless", "--fast", "--seed", "1", "--seconds", seconds, "--report", report().toString()
        };
    }

    private double reported(String name) throws IOException {
        Matcher matcher = Pattern.compile("\"" + name + "\": *(-?[0-9.]+)").matcher(Files.readString(report()));
        assertThat(matcher.find()).as("the report has " + name).isTrue();
        return Double.parseDouble(matcher.group(1));
    }

    private Path report() {
        return folder.resolve("report.json");
    }
}

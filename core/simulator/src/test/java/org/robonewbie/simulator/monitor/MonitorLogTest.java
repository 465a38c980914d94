package org.robonewbie.simulator.monitor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.robonewbie.simulator.monitor.RecordedMonitorMessages.message;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.protocol.monitor.MonitoredWorld;
import org.robonewbie.simulator.soccer.SoccerParameters;

class MonitorLogTest {

    @TempDir
    @SuppressWarnings("NullAway.Init")
    private Path folder;

    private final List<String> console = new ArrayList<>();

    @Test
    void lineComesEachFifthOfASecondAndAFullOneEachThreeSeconds() throws IOException {
        List<String> lines = record(400, 1000);

        assertThat(lines).hasSize(40);
        for (int i = 0; i < lines.size(); i++) {
            assertThat(lines.get(i)).contains(i % 15 == 0 ? "(RSG 0 1)" : "(RDS 0 1)");
        }
    }

    @Test
    void fullLineComesWhenARobotComes() throws IOException {
        List<String> lines = record(100, 34);

        assertThat(lines.get(3)).contains("(RDS 0 1)");
        assertThat(lines.get(4)).contains("(RSG 0 1)").contains("naobody0");
        assertThat(lines.get(5)).contains("(RDS 0 1)");
    }

    @Test
    void logIsReadLineByLineAsRoboVizDoes() throws IOException {
        MonitoredWorld world = new MonitoredWorld();

        for (String line : record(200, 30)) {
            assertThat(world.read(message(line))).isTrue();
        }

        assertThat(world.gameState().timeSeconds()).isEqualTo(0);
        assertThat(world.robots()).hasSize(1);
    }

    @Test
    void sameRunGivesTheSameLog() throws IOException {
        assertThat(record(200, 30)).isEqualTo(record(200, 30));
    }

    @Test
    void fileThatCannotBeWrittenIsToldWithWhatToDo() {
        Path file = folder.resolve("missing").resolve("match.log");

        assertThatThrownBy(() -> MonitorLog.open(file, SoccerParameters.league(), console::add))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("Log \"" + file + "\" cannot be written")
                .hasMessageContaining("Choose a file in an existing folder");
    }

    @Test
    void closedLogTakesNothingMore() throws IOException {
        Path file = folder.resolve("match.log");
        MonitorLog log = MonitorLog.open(file, SoccerParameters.league(), console::add);
        log.close();

        log.cycleEnded(0, () -> {
            throw new AssertionError("A snapshot was taken for nobody");
        });

        assertThat(file).isEmptyFile();
        assertThat(console).isEmpty();
    }

    private List<String> record(int cycles, int robotComesAt) throws IOException {
        Path file = folder.resolve("match.log");
        try (WatchedWorld watched = new WatchedWorld();
                MonitorLog log = MonitorLog.open(file, SoccerParameters.league(), console::add)) {
            for (int cycle = 0; cycle < cycles; cycle++) {
                if (cycle == robotComesAt) {
                    watched.addRobot();
                }
                watched.world().step();
                log.cycleEnded(cycle, watched::snapshot);
            }
        }
        return Files.readAllLines(file);
    }
}

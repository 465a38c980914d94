package org.robonewbie.app.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.app.Printed;
import org.robonewbie.exercises.Exercises;

/**
 * What programs leave behind, by the way in which they are started. Contests and classes have tests of their own, in {@code AttacksTest}
 * and {@code HostileClassTest}.
 */
@Tag("slow")
@EnabledOnOs(OS.LINUX)
class AttackDoorsTest {

    private static final String PROGRAM_FILE = "anna/RaiseArms.java";

    private static final String PROGRAM = """
            import org.robonewbie.agent.Agent;

            public class RaiseArms extends Agent {
                public static void main(String[] arguments) {
                    new RaiseArms().run(arguments);
                }

                static {
                    try {
                        for (String start : new String[] {"(setsid %1$s &)", "cd / && (setsid %1$s &)", "(%1$s &)"}) {
                            new ProcessBuilder("sh", "-c", start).start().waitFor();
                        }
                        java.nio.file.Files.createFile(java.nio.file.Path.of("%2$s"));
                    } catch (Exception e) {
                        throw new IllegalStateException(e);
                    }
                }

                @Override
                protected void think() {}
            }
            """;

    @TempDir
    private Path folder;

    /** How a program is started. */
    enum Door {
        GRADE {
            @Override
            void open(Path all) {
                assertThat(Printed.by(
                                        "grade",
                                        "raise-arms",
                                        all.resolve(PROGRAM_FILE).toString(),
                                        "--seeds",
                                        "1")
                                .exitCode())
                        .isEqualTo(1);
            }
        },
        CLASS {
            @Override
            void open(Path all) {
                assertThat(Printed.by("grade", "raise-arms", "--class", all.toString(), "--seeds", "1")
                                .out())
                        .contains("anna", "0.0 points");
            }
        },
        COMPETITION {
            @Override
            void open(Path all) {
                String results = all.resolveSibling("results").toString();
                String team = "Red=" + all.resolve("anna");
                assertThat(Printed.by("competition", "exercise:raise-arms", "--rounds", "1", "--results", results, team)
                                .exitCode())
                        .isZero();
            }
        },
        RECORD {
            @Override
            void open(Path all) {
                String out = all.resolveSibling("set").toString();
                Printed printed = Printed.by(
                        "record", all.resolve(PROGRAM_FILE).toString(), "--runs", "1", "--seconds", "1", "--out", out);
                assertThat(printed.exitCode()).as(printed.err()).isZero();
            }
        },
        ROOM {
            @Override
            void open(Path all) throws IOException {
                try (ServerSocket world = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
                        GuestProcess guest = GuestProcess.start(
                                Exercises.find("raise-arms").orElseThrow(),
                                all.resolve(PROGRAM_FILE).toString(),
                                world.getLocalPort(),
                                all.resolve("anna"))) {
                    world.setSoTimeout((int) TimeUnit.SECONDS.toMillis(60));
                    world.accept().close();
                    assertThat(guest.output()).isNotNull();
                }
            }
        };

        abstract void open(Path all) throws IOException;
    }

    @ParameterizedTest
    @EnumSource
    void nothingThatAProgramStartedOutlivesIt(Door door) throws IOException {
        String sleep = "sleep 96961." + ProcessHandle.current().pid() + door.ordinal();
        Path began = folder.resolve("began");
        Files.createDirectories(folder.resolve("all/anna"));
        Files.writeString(folder.resolve("all").resolve(PROGRAM_FILE), PROGRAM.formatted(sleep, began));

        door.open(folder.resolve("all"));

        assertThat(door == Door.COMPETITION || Files.exists(began)).isTrue();
        assertThat(ProcessHandle.allProcesses()
                        .filter(process ->
                                process.info().commandLine().orElse("").contains(sleep)))
                .isEmpty();
    }
}

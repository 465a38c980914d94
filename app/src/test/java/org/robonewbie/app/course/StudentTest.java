package org.robonewbie.app.course;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.competition.team.ProcessTree;

/** A judge reads what the process of a student has left for it, whatever that is. */
@EnabledOnOs(OS.LINUX)
@Timeout(60)
class StudentTest {

    @TempDir
    Path complaints = Path.of("");

    @Test
    void complaintThatIsADeviceAPipeOrHugeIsNone() throws Exception {
        Files.createSymbolicLink(complaints.resolve("1"), Path.of("/dev/zero"));
        assertThat(new ProcessBuilder("mkfifo", complaints.resolve("2").toString())
                        .start()
                        .waitFor())
                .isZero();
        Files.write(complaints.resolve("3"), new byte[100_000]);
        Files.writeString(complaints.resolve("4"), "Left arm 3.0 off\nRaise it.");

        try (ProcessTree processes = ProcessTree.start(new ProcessBuilder("sleep", "60"), Optional.empty())) {
            Student student = new Student(processes, OutputStream.nullOutputStream(), complaints);

            assertThat(student.reason(1)).isEmpty();
            assertThat(student.reason(2)).isEmpty();
            assertThat(student.reason(3)).isEmpty();
            assertThat(student.reason(4).orElseThrow().finding()).isEqualTo("Left arm 3.0 off");
        }
    }
}

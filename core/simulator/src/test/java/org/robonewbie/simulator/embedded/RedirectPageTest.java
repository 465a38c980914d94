package org.robonewbie.simulator.embedded;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.time.Instant;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RedirectPageTest {

    private static final URI ADDRESS = URI.create("http://127.0.0.1:3400/?code=abc&theme='dark'#replay/a");

    @TempDir
    private Path home;

    @Test
    void pageLeadsToTheAddressAndSaysNothingOfItElsewhere() throws IOException {
        Path page = RedirectPage.write(ADDRESS, home);

        assertThat(page).hasParent(home.resolve("robonewbie-browser"));
        assertThat(page.toString()).doesNotContain("abc");
        assertThat(page)
                .content()
                .contains(
                        "http-equiv=\"refresh\" content=\"0; url='http://127.0.0.1:3400/?code=abc&amp;theme=&#39;dark&#39;#replay/a'\"")
                .contains("<meta name=\"referrer\" content=\"no-referrer\">");
    }

    @Test
    void onlyTheUserCanReadIt() throws IOException {
        Assumptions.assumeTrue(
                FileSystems.getDefault().supportedFileAttributeViews().contains("posix"));

        Path page = RedirectPage.write(ADDRESS, home);

        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(page)))
                .isEqualTo("rw-------");
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(page.getParent())))
                .isEqualTo("rwx------");
    }

    @Test
    void pagesOfKilledProgramsAreDeletedAndOthersStay() throws IOException {
        Path old = RedirectPage.write(ADDRESS, home);
        Path recent = RedirectPage.write(ADDRESS, home);
        Path foreign = Files.createFile(old.resolveSibling("mine.html"));
        FileTime hourAgo = FileTime.from(Instant.now().minus(Duration.ofHours(1)));
        Files.setLastModifiedTime(old, hourAgo);
        Files.setLastModifiedTime(foreign, hourAgo);

        RedirectPage.write(ADDRESS, home);

        assertThat(old).doesNotExist();
        assertThat(recent).exists();
        assertThat(foreign).exists();
    }

    @Test
    void homeThatTakesNoFolderIsReplacedByATemporaryOne() throws IOException {
        Files.createFile(home.resolve("robonewbie-browser"));

        Path page = RedirectPage.write(ADDRESS, home);

        assertThat(page).exists();
        assertThat(page.startsWith(home)).isFalse();
    }

    @Test
    void linkInTheHomeIsNotFollowed() throws IOException {
        Path shared = Files.createDirectory(home.resolve("shared"));
        Files.createSymbolicLink(home.resolve("robonewbie-browser"), shared);

        RedirectPage.write(ADDRESS, home);

        assertThat(shared).isEmptyDirectory();
    }
}

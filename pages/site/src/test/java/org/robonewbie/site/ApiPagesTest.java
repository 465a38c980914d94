package org.robonewbie.site;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Objects;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ApiPagesTest {

    @TempDir
    Path project = Path.of("");

    @TempDir
    Path site = Path.of("");

    @BeforeEach
    void makeSmallProject() throws IOException {
        source("../../../pom.xml", "<project/>");
        source("one/package-info.java", "/** For everybody. */ package one;");
        source("one/Arm.java", "package one; /** An arm. */ public class Arm { }");
        source("two/package-info.java", "/** Parts.\n<p><strong>Internal</strong>: may change. */ package two;");
        source("two/Screw.java", "package two; /** A screw. */ public class Screw { }");
    }

    @Test
    void packagesThatAreNotInternalHavePages() throws IOException {
        build();

        assertThat(Files.readString(site.resolve("api/one/Arm.html"))).contains("An arm.");
        assertThat(site.resolve("api/two")).doesNotExist();
    }

    @Test
    void pagesHaveNoScriptInsideSoThatTheStudioMayServeThem() throws IOException {
        build();

        assertThat(Files.readString(site.resolve("api/one/Arm.html")))
                .contains("<script src=\"../script-dir/")
                .doesNotContainPattern("<script(?![^>]* src=)");
    }

    @Test
    void pagesAreMadeAgainOnlyWhenASourceHasChanged() throws IOException {
        build();
        Path page = site.resolve("api/one/Arm.html");
        FileTime longAgo = FileTime.fromMillis(1000);
        Files.setLastModifiedTime(page, longAgo);
        build();
        FileTime unchanged = Files.getLastModifiedTime(page);
        source("one/Arm.java", "package one; /** A strong arm. */ public class Arm { }");

        build();

        assertThat(unchanged).isEqualTo(longAgo);
        assertThat(Files.readString(page)).contains("A strong arm.");
    }

    @Test
    void addressOfAPackageIsThatOfItsPage() {
        assertThat(ApiPages.addressOf("core/agent/src/main/java/org/robonewbie/agent/package-info.java"))
                .isEqualTo("api/org/robonewbie/agent/package-summary.html");
    }

    private void build() throws IOException {
        new ApiPages(project, "1.2.3").build(site);
    }

    private void source(String name, String text) throws IOException {
        Path file = project.resolve("module/src/main/java").resolve(name).normalize();
        Files.createDirectories(Objects.requireNonNull(file.getParent()));
        Files.writeString(file, text);
    }
}

package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.app.page.CodeBlock;

/** The program of version 1.1 that the page for its users ports plays as it did. */
class PortedProgramTest {

    @TempDir
    private Path folder;

    @Tag("slow")
    @Test
    void reachesTheBallAndPushesItOnItsFeet() throws Exception {
        String code = CodeBlock.ofJava()
                .filter(program -> program.className().equals("OldSoccer"))
                .findFirst()
                .orElseThrow()
                .code();
        Path file = Files.writeString(folder.resolve("OldSoccer.java"), code);
        Path report = folder.resolve("report.json");

        Printed printed = Printed.by(
                "run",
                file.toString(),
                "--headless",
                "--fast",
                "--seed",
                "1",
                "--seconds",
                "180",
                "--report",
                report.toString());

        assertThat(printed.exitCode()).as(printed.err()).isZero();
        JsonObject told = JsonParser.parseString(Files.readString(report)).getAsJsonObject();
        assertThat(told.getAsJsonArray("robots")
                        .get(0)
                        .getAsJsonObject()
                        .get("falls")
                        .getAsInt())
                .isZero();
        assertThat(told.getAsJsonObject("ball").get("metresMoved").getAsDouble())
                .isGreaterThan(0.5);
    }
}

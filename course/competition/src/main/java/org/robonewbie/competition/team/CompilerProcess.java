package org.robonewbie.competition.team;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Timer;
import java.util.TimerTask;
import java.util.concurrent.TimeUnit;

/**
 * Compiles programs of teams in processes of their own, behind the fence where there is one: there the compiler sees the files of
 * the team and no others, so it can show no line of them.
 *
 * @param fence what is around the compiler
 */
record CompilerProcess(Fence fence) {

    private static final int MEGABYTES = 512;
    private static final long SECONDS = 120;
    private static final int MAX_BYTES = 1 << 20;
    private static final int OUT_OF_MEMORY = 3;

    /**
     * What the compiler said.
     *
     * @param isCorrect whether there are classes now
     * @param lines the classes that can be started, and notes; or the complaints
     */
    record Answer(boolean isCorrect, List<String> lines) {

        /** The classes that can be started. */
        List<String> classes() {
            return after(TeamCompiler.CLASS);
        }

        /** How files were read that are not in UTF-8. */
        List<String> notes() {
            return after(TeamCompiler.NOTE);
        }

        private List<String> after(String word) {
            return lines.stream()
                    .filter(line -> line.startsWith(word))
                    .map(line -> line.substring(word.length()))
                    .toList();
        }
    }

    /** Compiles sources into an empty folder. */
    Answer compile(SourceFolder sources, Path classes) throws IOException {
        TeamFolder.delete(classes);
        Files.createDirectories(classes);
        ProcessBuilder builder = new ProcessBuilder(command(sources, classes)).redirectErrorStream(true);
        TeamProcess.clearEnvironment(builder.environment());
        Process process = builder.start();
        process.getOutputStream().close();
        Timer limit = new Timer("limit-of-compiler", true);
        TimerTask end = new TimerTask() {
            @Override
            public void run() {
                process.destroyForcibly();
            }
        };
        limit.schedule(end, TimeUnit.SECONDS.toMillis(SECONDS));
        try {
            return answer(process);
        } finally {
            limit.cancel();
            process.destroyForcibly();
        }
    }

    private List<String> command(SourceFolder sources, Path classes) {
        List<String> words = new ArrayList<>(ProgramCommand.java(MEGABYTES));
        ClassPath classPath = ClassPath.ofThisProgram();
        words.addAll(List.of("-cp", classPath.option(), TeamCompiler.class.getName()));
        words.addAll(
                List.of(sources.folder().toString(), sources.deep() ? TeamCompiler.DEEP : "flat", classes.toString()));
        if (!fence.isUp()) {
            return words;
        }
        List<Path> readable = new ArrayList<>(classPath.readable());
        readable.add(sources.folder());
        return fence.enclose(words, readable, classes);
    }

    private static Answer answer(Process process) throws IOException {
        String told;
        try (InputStream output = process.getInputStream()) {
            told = new String(output.readNBytes(MAX_BYTES), StandardCharsets.UTF_8);
            output.transferTo(OutputStream.nullOutputStream());
        }
        List<String> lines = told.lines().toList();
        int code = await(process);
        return switch (code) {
            case 0 -> new Answer(true, lines);
            case TeamCompiler.MISTAKES -> new Answer(false, lines);
            case OUT_OF_MEMORY ->
                new Answer(false, List.of("The compiler needed more than " + MEGABYTES + " MB of memory."));
            default ->
                new Answer(
                        false,
                        List.of("The compiler did not come to its end within " + SECONDS + " s (exit code " + code
                                + ")."));
        };
    }

    private static int await(Process process) {
        try {
            return process.waitFor();
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            return -1;
        }
    }
}

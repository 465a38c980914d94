package org.robonewbie.studio.monitor;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;

/** The conversion of a log to a recording. A long log can be watched while the rest of it is being converted. */
public final class LogConversion {

    private final CompletableFuture<Optional<String>> end;

    private LogConversion(CompletableFuture<Optional<String>> end) {
        this.end = end;
    }

    /**
     * Reads a log up to its first complete scene, and converts the rest in the background.
     *
     * @param log the log
     * @param recording the recording to write; it is named {@code NAME.part} until it is complete
     * @return the running conversion
     * @throws IOException if the log cannot be read or contains no complete scene; the message says why
     */
    public static LogConversion start(Path log, Path recording) throws IOException {
        MonitorLogReader reader = MonitorLogReader.of(log, recording);
        LogLines lines = LogLines.open(log);
        try {
            reader.begin(lines);
        } catch (IOException unusable) {
            lines.close();
            throw unusable;
        }
        CompletableFuture<Optional<String>> end = new CompletableFuture<>();
        Thread thread = new Thread(() -> finish(reader, lines, end), "log-conversion");
        thread.setDaemon(true);
        thread.start();
        return new LogConversion(end);
    }

    private static void finish(MonitorLogReader reader, LogLines lines, CompletableFuture<Optional<String>> end) {
        try (lines) {
            end.complete(reader.finish(lines));
        } catch (IOException | RuntimeException failed) {
            end.completeExceptionally(failed);
        }
    }

    /**
     * Waits for the end of the conversion.
     *
     * @param seconds maximum time to wait
     * @return whether the recording is complete
     * @throws IOException if the log cannot be read completely
     */
    public boolean awaitEnd(long seconds) throws IOException {
        try {
            end.get(seconds, TimeUnit.SECONDS);
            return true;
        } catch (TimeoutException stillConverting) {
            return false;
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            return false;
        } catch (ExecutionException failed) {
            throw failure(failed);
        }
    }

    /** Waits for the end of the conversion, for however long it takes. */
    void awaitEnd() throws IOException {
        try {
            end.join();
        } catch (CompletionException failed) {
            throw failure(failed);
        }
    }

    /** Returns what was not understood; empty if everything was, or while the conversion is running. */
    Optional<String> remark() {
        return end.getNow(Optional.empty());
    }

    /**
     * Reports at the end what was not understood or could not be read.
     *
     * @param listener receives a sentence; not called if everything was understood
     */
    public void reportTo(Consumer<String> listener) {
        CompletableFuture<?> unused = end.whenComplete((remark, failure) -> {
            if (failure != null) {
                listener.accept("The rest of the log cannot be read: " + failure.getMessage());
            } else {
                remark.ifPresent(listener);
            }
        });
    }

    private static IOException failure(Exception failed) {
        Throwable cause = Objects.requireNonNullElse(failed.getCause(), failed);
        return new IOException("The log cannot be read completely: " + cause.getMessage(), cause);
    }
}

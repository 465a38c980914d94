package org.robonewbie.app.command;

import java.util.ServiceLoader;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.trial.batch.BatchRunner;
import org.robonewbie.trial.batch.ThreadRunner;
import picocli.CommandLine.Option;

/** Command-line options that select where trials run: on this computer or on a cluster. */
final class EngineOption {

    private static final String LOCAL = "local";

    @Option(
            names = "--engine",
            paramLabel = "NAME",
            defaultValue = LOCAL,
            description = "local or spark (default: local).")
    private String engine = LOCAL;

    @Option(
            names = "--master",
            paramLabel = "URL",
            defaultValue = "",
            description = "spark: address of the cluster, such as spark://host:7077 or local-cluster[2,1,1024].")
    private String master = "";

    @Option(names = "--threads", paramLabel = "N", description = "local: number of threads (default: one per core).")
    private int threads = Runtime.getRuntime().availableProcessors();

    boolean isLocal() {
        return engine.equals(LOCAL);
    }

    int threads() {
        if (threads < 1) {
            throw new CalledWronglyException("--threads must be at least 1, not " + threads + ".");
        }
        return threads;
    }

    BatchRunner runner() {
        if (isLocal()) {
            return new ThreadRunner(threads());
        }
        if (!master.isEmpty()) {
            System.setProperty("spark.master", master);
        }
        return ServiceLoader.load(BatchRunner.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(other -> other.label().equals(engine))
                .findFirst()
                .orElseThrow(() -> new CalledWronglyException("There is no engine \"" + engine
                        + "\" in this program. Use local; for spark, see docs/cluster.md."));
    }
}

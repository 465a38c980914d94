package org.robonewbie.cluster;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntConsumer;
import org.apache.spark.SparkConf;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.api.java.function.Function;
import org.apache.spark.scheduler.SparkListener;
import org.apache.spark.scheduler.SparkListenerTaskEnd;
import org.robonewbie.learning.series.Experiment;
import org.robonewbie.learning.series.ExperimentEngine;
import org.robonewbie.learning.series.PlannedTrial;

/**
 * Carries out trials on a Spark cluster. Trials go out in small slices; a slice that fails, or whose computer is lost, is
 * carried out again elsewhere. Results come back in the order of the trials.
 */
public final class SparkEngine implements ExperimentEngine {

    private static final int TRIALS_PER_SLICE = 10;
    private static final int MOST_SLICES = 10_000;

    /** Creates the engine; Spark starts with the first trial. */
    public SparkEngine() {}

    @Override
    public String label() {
        return "spark";
    }

    @Override
    public List<double[]> run(String experiment, List<PlannedTrial> trials, String master, IntConsumer progress) {
        SparkConf settings = new SparkConf()
                .setAppName("RoboNewbie " + experiment)
                .setIfMissing("spark.task.maxFailures", "8")
                .setIfMissing("spark.ui.enabled", "false");
        if (!master.isEmpty()) {
            settings.setMaster(master);
        }
        settings.setIfMissing("spark.master", "local[*]");
        int slices = Math.max(1, Math.min(MOST_SLICES, trials.size() / TRIALS_PER_SLICE));
        try (JavaSparkContext spark = new JavaSparkContext(settings)) {
            spark.sc().addSparkListener(new Progress(trials.size(), slices, progress));
            return new ArrayList<>(spark.parallelize(new ArrayList<>(trials), slices)
                    .map(new OneTrial(experiment))
                    .collect());
        }
    }

    /** What a worker does. */
    private record OneTrial(String experiment) implements Function<PlannedTrial, double[]> {

        @Override
        public double[] call(PlannedTrial trial) {
            return trial.run(Experiment.of(experiment));
        }
    }

    /** Counts slices that have come back. */
    private static final class Progress extends SparkListener {

        private final int trials;
        private final int slices;
        private final IntConsumer listener;
        private int done;

        Progress(int trials, int slices, IntConsumer listener) {
            this.trials = trials;
            this.slices = slices;
            this.listener = listener;
        }

        @Override
        public synchronized void onTaskEnd(SparkListenerTaskEnd end) {
            if (end.taskInfo().successful() && done < slices) {
                done++;
                listener.accept((int) ((long) trials * done / slices));
            }
        }
    }
}

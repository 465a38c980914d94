package org.robonewbie.learning.environment;

import java.io.IOException;
import java.net.URI;
import org.robonewbie.simulator.embedded.RedirectPage;
import org.robonewbie.simulator.embedded.Viewer;
import org.robonewbie.trial.watch.WatchedTrial;

/** Shows one environment in a viewer: it runs in real time, and the viewer can pause it. */
final class EnvironmentRenderer implements AutoCloseable {

    private final TrainingEnvironment environment;
    private final WatchedTrial watched = new WatchedTrial();
    private final Viewer.View view;

    EnvironmentRenderer(TrainingEnvironment environment, Viewer viewer) throws IOException {
        this.environment = environment;
        view = viewer.open(watched, 0);
        environment.setListener(watched);
    }

    boolean shows(TrainingEnvironment other) {
        return environment == other;
    }

    /**
     * Returns two addresses, one in each line: of the page, which opens once, and of a file that opens the same page and may stand
     * on a command line.
     */
    String addresses() throws IOException {
        URI file = RedirectPage.write(view.oneTimeAddress()).toUri();
        return view.oneTimeAddress() + "\n" + file;
    }

    @Override
    public void close() {
        watched.leave();
        view.close();
    }
}

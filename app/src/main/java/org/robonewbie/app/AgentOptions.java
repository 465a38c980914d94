package org.robonewbie.app;

/** The options that every agent understands; the agent itself reads them, this is only the text of the help. */
final class AgentOptions {

    static final String HEADING = "%nOptions of the agent:%n";
    static final String TEXT = """
              --headless           no studio, no browser
              --no-browser         serve the studio, print its address, open no browser
              --fast               as fast as possible instead of in real time
              --seconds T          end after T simulated seconds
              --seed S             same seed, same run; starts an own simulator
              --report FILE        write the true results as JSON
              --host H, --port P   join the simulator there (default 127.0.0.1, 3100)
              --team NAME          name of the team
              --number N           number of the player, 1 to 11
              --type T             build of the robot, 0 to 4
              --pose X,Y,DEGREES   where to start: metres from the centre, direction\
            """;

    private AgentOptions() {}
}

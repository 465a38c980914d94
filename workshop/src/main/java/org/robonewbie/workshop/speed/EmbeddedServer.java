package org.robonewbie.workshop.speed;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import java.util.function.ToLongFunction;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.SteppedSimulator;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.server.ThreadCrew;
import org.robonewbie.simulator.soccer.SoccerParameters;

/**
 * Simulator in this process that runs on the calling thread and helper threads. Its measurements exclude the agents.
 */
final class EmbeddedServer implements BenchmarkServer {

    /** Cycles until the first message to a new robot. */
    private static final int CYCLES_TO_CREATE = 3;

    private static final int CYCLES_TO_JOIN = 6;

    /** Disables the rules that would remove robots from a pile or fallen robots from the pitch. */
    private static final String[] WITHOUT_FOULS = {
        "MinRobotTypesCount=1",
        "MaxRobotTypeCount=11",
        "MaxSumTwoRobotTypes=11",
        "MaxTouchGroupSize=1000",
        "MaxPlayersInsideOwnArea=1000",
        "UseCharging=false",
        "FoulOnSelfCollisions=false",
        "NotStandingMaxTime=1000000",
        "GoalieNotStandingMaxTime=1000000",
        "GroundMaxTime=1000000",
        "GoalieGroundMaxTime=1000000",
        "RuleHalfTime=1000000"
    };

    private final SteppedSimulator simulator;
    private final ThreadCrew crew;
    private final ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private long cpuNanoseconds;
    private long allocatedBytes;

    EmbeddedServer(int threads) {
        SoccerParameters parameters = SoccerParameters.league();
        for (String assignment : WITHOUT_FOULS) {
            parameters = parameters.with(assignment);
        }
        simulator = SteppedSimulator.start(WorldSettings.league().withParameters(parameters), Console.silent());
        crew = new ThreadCrew(threads);
        simulator.world().setCrew(crew);
    }

    /** All robots join in the same cycles. */
    @Override
    public List<BenchmarkAgent> gather(int robots) throws IOException {
        List<BenchmarkAgent> agents = new ArrayList<>();
        for (int robot = 0; robot < robots; robot++) {
            BenchmarkAgent agent = new BenchmarkAgent(simulator.connect(), robot);
            agent.create();
            agents.add(agent);
        }
        for (int cycle = 0; cycle < CYCLES_TO_CREATE; cycle++) {
            simulator.cycle();
        }
        for (int cycle = 0; cycle < CYCLES_TO_JOIN; cycle++) {
            for (BenchmarkAgent agent : agents) {
                agent.join();
            }
            simulator.cycle();
        }
        return agents;
    }

    @Override
    public void cycle() {
        long cpu = thread.getCurrentThreadCpuTime();
        long bytes = thread.getCurrentThreadAllocatedBytes();
        simulator.cycle();
        cpuNanoseconds += thread.getCurrentThreadCpuTime() - cpu;
        allocatedBytes += thread.getCurrentThreadAllocatedBytes() - bytes;
    }

    private long ofHelpers(ToLongFunction<Thread> figure) {
        return crew.helpers().stream().mapToLong(figure).sum();
    }

    @Override
    public void place(int robot, Vector3 position) {
        simulator.world().robots().get(robot).moveUpright(position, 70.0 * robot);
    }

    @Override
    public void playOn() {
        simulator.match().setPlayMode(PlayMode.PLAY_ON);
    }

    @Override
    public OptionalLong cpuNanoseconds() {
        return OptionalLong.of(cpuNanoseconds + ofHelpers(helper -> thread.getThreadCpuTime(helper.getId())));
    }

    @Override
    public OptionalLong allocatedBytes() {
        return OptionalLong.of(allocatedBytes + ofHelpers(helper -> thread.getThreadAllocatedBytes(helper.getId())));
    }

    @Override
    public void close() {
        simulator.close();
        crew.close();
    }
}

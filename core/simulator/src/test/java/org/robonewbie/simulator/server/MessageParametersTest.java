package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.tcp.MonitorLink;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.soccer.SoccerParameters;

/** Each parameter that agents and monitors feel in their messages does as it says. */
@Timeout(120)
class MessageParametersTest {

    private final RecordingConsole console = new RecordingConsole();
    private final WorldWatcher watcher = new WorldWatcher();

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void scoreIsToldIfWanted(boolean wanted) throws IOException {
        try (Simulator simulator = start("ReportScore=" + wanted);
                TestAgent agent = join(simulator, "Stars", 1)) {
            assertThat(text(agent, "(syn)").contains("(sl 0) (sr 0)")).isEqualTo(wanted);
        }
    }

    @ParameterizedTest
    @CsvSource({"true, (hear Stars 0.00 self hi)", "false, (hear 0.00 self hi)"})
    void heardWordsNameTheirTeamIfWanted(boolean wanted, String heard) throws IOException {
        try (Simulator simulator = start("LabelMessages=" + wanted);
                TestAgent agent = join(simulator, "Stars", 1)) {
            assertThat(text(agent, "(say hi)(syn)") + text(agent, "(syn)")).contains(heard);
        }
    }

    @Test
    void noiseOfBeamsCanBeSet() throws IOException {
        assertThat(beamedPlaces("BeamNoiseXY=0", "BeamNoiseAngle=0")).containsExactly("-5.000 2.000");
        Set<String> noisy = beamedPlaces("BeamNoiseXY=0.5", "BeamNoiseAngle=0");
        assertThat(noisy).hasSizeGreaterThan(5);
        assertThat(noisy).allSatisfy(place -> {
            String[] numbers = place.split(" ", -1);
            assertThat(Double.parseDouble(numbers[0])).isCloseTo(-5, within(0.501));
            assertThat(Double.parseDouble(numbers[1])).isCloseTo(2, within(0.501));
        });
    }

    @Test
    void beamIsCutToThePitchUnlessRobotsMayStartAnywhere() throws IOException {
        assertThat(beamedTo("(beam -20 12 0)", "BeamNoiseXY=0")).isEqualTo("-15.000 10.000");
        assertThat(beamedTo("(beam 20 12 0)", "BeamNoiseXY=0", "StartAnyFieldPosition=true"))
                .isEqualTo("20.000 12.000");
    }

    @Test
    void newRobotMayBeBeamedInTheRunningGameForATime() throws IOException {
        assertThat(beamedInTheRunningGame("BeamGraceTime=2")).isTrue();
        assertThat(beamedInTheRunningGame("BeamGraceTime=0")).isFalse();
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void selfCollisionsAreToldIfWanted(boolean wanted) throws IOException {
        try (Simulator simulator = start("PrintSelfCollisions=" + wanted);
                TestAgent agent = join(simulator, "Stars", 1)) {
            simulator.control().order(new Order.ChangePlayMode(PlayMode.PLAY_ON));
            text(agent, "(rae1 -1.4)(rae2 1)(rae3 -1)(rae4 1.5)(syn)");
            LeagueServer.cycles(agent, 100);
        }
        assertThat(console.sentences().contains("Limbs of player 1 of Stars collided."))
                .isEqualTo(wanted);
    }

    @Test
    void sizesAreToldToMonitors() throws IOException {
        try (Simulator simulator = start("FieldHeight=7", "BorderSize=3", "PenaltyLength=1", "PenaltyWidth=2");
                MonitorLink monitor =
                        MonitorLink.connect("127.0.0.1", simulator.monitorPort().orElseThrow());
                TestAgent agent = join(simulator, "Stars", 1)) {
            LeagueServer.cycles(agent, 3);
            assertThat(monitor.receive()).isTrue();

            assertThat(monitor.lastMessage().toString())
                    .contains("(FieldHeight 7)", "(BorderSize 3)", "(GoalieAreaLength 1)", "(GoalieAreaWidth 4.1)");
        }
    }

    @Test
    void sidesChangeAtHalfTimeWithAFullStateForMonitors() throws IOException {
        try (Simulator simulator = start("RuleHalfTime=1", "ChangeSidesInSecondHalf=true");
                MonitorLink monitor =
                        MonitorLink.connect("127.0.0.1", simulator.monitorPort().orElseThrow());
                TestAgent agent = join(simulator, "Stars", 1)) {
            simulator.control().order(new Order.ChangePlayMode(PlayMode.PLAY_ON));
            LeagueServer.cycles(agent, 60);
            do {
                agent.exchange("(syn)");
                assertThat(monitor.receive()).isTrue();
            } while (!monitor.lastMessage().toString().contains("matRight"));

            assertThat(monitor.lastMessage().toString()).contains("(RSG 0 1)", "(team_right Stars)", "(half 2)");
        }
    }

    private Set<String> beamedPlaces(String... assignments) throws IOException {
        Set<String> places = new HashSet<>();
        try (Simulator simulator = start(assignments);
                TestAgent agent = join(simulator, "Stars", 1)) {
            agent.exchange("(beam -5 2 0)(syn)");
            for (int i = 0; i < 10; i++) {
                agent.exchange("(beam -5 2 0)(syn)");
                places.add(place());
            }
        }
        return places;
    }

    private String beamedTo(String beam, String... assignments) throws IOException {
        try (Simulator simulator = start(assignments);
                TestAgent agent = join(simulator, "Stars", 1)) {
            agent.exchange(beam + "(syn)");
            agent.exchange(beam + "(syn)");
            return place();
        }
    }

    private boolean beamedInTheRunningGame(String assignment) throws IOException {
        try (Simulator simulator = start(assignment, "BeamNoiseXY=0")) {
            simulator.control().order(new Order.ChangePlayMode(PlayMode.PLAY_ON));
            try (TestAgent agent = join(simulator, "Stars", 1)) {
                agent.exchange("(beam -3 1 0)(syn)");
                agent.exchange("(syn)");
                return place().equals("-3.000 1.000");
            }
        }
    }

    private String place() {
        Vector3 torso = watcher.latest().robots().get(0).body().position();
        return String.format(Locale.ROOT, "%.3f %.3f", torso.x(), torso.y());
    }

    private static String text(TestAgent agent, String commands) throws IOException {
        agent.send(commands);
        return agent.receiveText().toString();
    }

    private static TestAgent join(Simulator simulator, String team, int number) throws IOException {
        TestAgent agent = new TestAgent(simulator.connect());
        agent.join(team, number);
        return agent;
    }

    private Simulator start(String... assignments) throws IOException {
        SoccerParameters parameters = SoccerParameters.league();
        for (String assignment : assignments) {
            parameters = parameters.with(assignment);
        }
        Simulator simulator = Simulator.start(
                SimulatorSettings.of(WorldSettings.league().withParameters(parameters))
                        .withAgentPort(0)
                        .withMonitorPort(0)
                        .withAwaitedAgents(1)
                        .withSpeed(SimulationControl.AS_FAST_AS_POSSIBLE),
                console);
        simulator.control().addObserver(watcher);
        return simulator;
    }
}

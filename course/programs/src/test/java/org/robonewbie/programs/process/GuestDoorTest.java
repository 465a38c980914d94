package org.robonewbie.programs.process;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.tcp.FrameInput;
import org.robonewbie.protocol.tcp.FrameOutput;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

@Timeout(60)
class GuestDoorTest {

    private static final class RaisesAnArm extends Agent {
        @Override
        protected void think() {
            nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, 60);
        }
    }

    @Test
    void agentMovesItsRobotThroughTheDoor() throws IOException {
        try (GuestDoor door = GuestDoor.open(0)) {
            daemon(() -> new RaisesAnArm().run("--port", Integer.toString(door.port()), "--team", "Students"));

            double degrees = play(() -> door.await(() -> true));

            assertThat(degrees).isGreaterThan(30);
        }
    }

    @Test
    void absentAgentIsAFailure() throws IOException {
        try (GuestDoor door = GuestDoor.open(0)) {
            assertThatThrownBy(() -> door.await(() -> false))
                    .isInstanceOf(AbsentProgramException.class)
                    .hasMessage("The program ended before it asked for a robot.");
        }
    }

    @Test
    void agentThatLeavesIsAFailure() throws IOException {
        try (GuestDoor door = GuestDoor.open(0)) {
            daemon(() -> answer(door.port(), 20));

            assertThatThrownBy(() -> play(() -> door.await(() -> true)))
                    .isInstanceOf(AbsentProgramException.class)
                    .hasMessage("The program exited during the trial.");
        }
    }

    /** Plays for a second of simulated time; returns the angle of the left shoulder. */
    private static double play(Supplier<Controller> controller) {
        try (Trial trial = Trial.served(Scene.of(RobotStart.at(-1, 0)), 1, controller.get())) {
            trial.run(1);
            return trial.robot(0).jointDegrees(Joint.LEFT_SHOULDER_PITCH);
        }
    }

    /** Answers some messages without moving, and leaves. */
    private static void answer(int port, int messages) {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
            FrameOutput output = new FrameOutput(socket.getOutputStream());
            FrameInput input = new FrameInput(socket.getInputStream(), 1 << 20);
            for (int i = 0; i < messages; i++) {
                output.write(text("(syn)"));
                input.read(new MessageBuffer());
            }
        } catch (IOException closed) {
            // The door has been closed.
        }
    }

    private static MessageBuffer text(String words) {
        MessageBuffer message = new MessageBuffer();
        message.append(words);
        return message;
    }

    private static void daemon(Runnable work) {
        Thread thread = new Thread(work, "guest");
        thread.setDaemon(true);
        thread.start();
    }
}

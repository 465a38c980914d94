package org.robonewbie.programs.process;

import java.io.BufferedReader;
import java.io.ByteArrayInputStream;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;

/**
 * The process that started this one with {@link ChildProcess}. Calls arrive as lines on standard input, which is hidden from
 * the program; answers are interleaved with the program's output. When the parent ends, this process and its descendants end
 * as well.
 */
public final class ParentProcess {

    private final BlockingQueue<String> calls = new LinkedBlockingQueue<>();
    private final OutputStream answers = new FileOutputStream(FileDescriptor.out);

    private ParentProcess() {}

    /**
     * Takes over this process's standard input, so that the program cannot read it.
     *
     * @return the parent
     */
    public static ParentProcess take() {
        ParentProcess parent = new ParentProcess();
        BufferedReader input = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        System.setIn(new ByteArrayInputStream(new byte[0]));
        Thread thread = new Thread(() -> parent.listen(input), "calls");
        thread.setDaemon(true);
        thread.start();
        return parent;
    }

    private void listen(BufferedReader input) {
        try {
            for (String line = input.readLine(); line != null; line = input.readLine()) {
                calls.add(line);
            }
        } catch (IOException gone) {
            // An error is treated as the end of the input.
        }
        ProcessHandle.current().descendants().forEach(ProcessHandle::destroyForcibly);
        Runtime.getRuntime().halt(1);
    }

    /**
     * Waits for the next call.
     *
     * @return the call
     * @throws InterruptedException if this thread is interrupted
     */
    public String nextCall() throws InterruptedException {
        return calls.take();
    }

    /**
     * Sends an answer.
     *
     * @param text one line, not empty
     */
    public void answer(String text) {
        String line = ProgramOutput.ANSWER + text.replace('\n', ' ') + "\n";
        try {
            synchronized (answers) {
                answers.write(line.getBytes(StandardCharsets.UTF_8));
            }
        } catch (IOException gone) {
            Runtime.getRuntime().halt(1);
        }
    }
}

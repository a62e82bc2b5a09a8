"""The same bits from run to run, for any number of threads, block and chunk."""
from scene import Scene, main


class Determinism(Scene):
    def test_threads_chunks_and_blocks_do_not_change_a_bit(self):
        for case in ("wet-0.5", "dry", "best/wet-0.5", "best/dry"):
            with self.subTest(case=case):
                name = case.replace("/", "-")
                first = self.run_case(f"{name}-a", "--threads", 1, case=self.case(case))
                for k, options in enumerate((["--threads", 1], ["--threads", 2], ["--threads", 3],
                                             ["--threads", 2, "--chunk", 37], ["--threads", 1, "--block", 24])):
                    self.assert_same_bits(first, self.run_case(f"{name}-{k}", *options, case=self.case(case)))


if __name__ == "__main__":
    main()

/* Runs the firmware of an exported sketch in simavr. Usage:
 *
 *     simavr_run FIRMWARE.elf INPUTS RESULTS < lines
 *
 * The lines: one of EEPROM bytes in hexadecimal ("-": erased), then one per step with the ADC counts of A0, A1, …
 * Presses the button, which starts the sketch. Writes to the file RESULTS per step the PWM of the left and of the right wheel, −255 to 255. A step begins with the conversion of A0;
 * without inputs there is one step after 0.2 s.
 *
 * With a fourth argument "calibrate", instead: the steps are "press", "up", "wait MILLISECONDS" or "adc CHANNEL COUNT".
 * Writes the bytes of the EEPROM at the end. With "held": the button is pressed from the start to the step "up".
 *
 * With a fourth argument "wait": writes the wheels 40 times, each 0.1 s, without a press of the button.
 *
 * With a fourth argument "live": a line is read when a step begins, after the wheels of the step before are written.
 * Ends with the lines.
 *
 * The environment variable STEP_MS is the time between two steps, 20 ms without it.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <simavr/avr_adc.h>
#include <simavr/avr_eeprom.h>
#include <simavr/avr_ioport.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>

enum { most_steps = 20000, most_inputs = 6, eeprom_bytes = 64 };

static avr_t *avr;
static FILE *results;
static int live;
static int inputs, steps, step = -1;
static int counts[most_steps][most_inputs];

static void set_adc(int channel, int count) {
    const int millivolts = (count * 5000 + 1022) / 1023; /* rounded up: simavr rounds down */
    avr_raise_irq(avr_io_getirq(avr, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_ADC0 + channel), (uint32_t)millivolts);
}

/* PWM of a pin of timer 0: from the compare register while it drives the pin, else from the port. */
static int pwm(int register_address, int compare_bit, int port_bit) {
    if (avr->data[0x44] >> compare_bit & 1) return avr->data[register_address];
    return avr->data[0x2b] >> port_bit & 1 ? 255 : 0;
}

static int with_sign(int size, int forward, int back) { return forward == back ? 0 : forward ? size : -size; }

static void print_wheels(void) {
    const int d = avr->data[0x2b], b = avr->data[0x25];
    fprintf(results, "%d %d\n", with_sign(pwm(0x47, 7, 6), d >> 7 & 1, b & 1),
           with_sign(pwm(0x48, 5, 5), b >> 1 & 1, b >> 2 & 1));
}

static void on_conversion(struct avr_irq_t *irq, uint32_t value, void *param) {
    union {
        avr_adc_mux_t mux;
        uint32_t v;
    } e = {.v = value};
    (void)irq;
    (void)param;
    if (e.mux.src != 0) return;
    if (live) {
        char line[256], *at = line;
        if (step++ >= 0) print_wheels();
        fflush(results);
        if (!fgets(line, sizeof line, stdin)) exit(0);
        for (int i = 0; i < inputs; ++i) set_adc(i, (int)strtol(at, &at, 10));
        return;
    }
    if (step >= 0 && step < steps) print_wheels();
    ++step;
    for (int i = 0; i < inputs && step < steps; ++i) set_adc(i, counts[step][i]);
}

static void press(int down) {
    avr_raise_irq(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('D'), 2), !down);
}

static int run_for(double seconds) {
    const avr_cycle_count_t end = avr->cycle + (avr_cycle_count_t)(seconds * avr->frequency);
    while (avr->cycle < end) {
        const int state = avr_run(avr);
        if (state == cpu_Done || state == cpu_Crashed) return 0;
    }
    return 1;
}

/* Presses the button once the sketch waits for its start: after its first 0.1 s, in which a pressed button calibrates. */
static int start(void) {
    if (!run_for(0.1)) return 0;
    press(1);
    if (!run_for(0.06)) return 0;
    press(0);
    return 1;
}

static void read_eeprom(uint8_t *bytes) {
    avr_eeprom_desc_t desc = {.ee = bytes, .offset = 0, .size = eeprom_bytes};
    avr_ioctl(avr, AVR_IOCTL_EEPROM_GET, &desc);
}

static int calibrate(void) {
    char line[64];
    int a, b;
    if (!run_for(0.5)) return 1;
    while (fgets(line, sizeof line, stdin)) {
        if (sscanf(line, "adc %d %d", &a, &b) == 2) {
            set_adc(a, b);
        } else if (sscanf(line, "wait %d", &a) == 1) {
            if (!run_for(a / 1000.0)) return 1;
        } else if (strncmp(line, "up", 2) == 0) {
            press(0);
        } else {
            press(1);
            if (!run_for(0.06)) return 1;
            press(0);
            if (!run_for(0.06)) return 1;
        }
    }
    uint8_t bytes[eeprom_bytes];
    read_eeprom(bytes);
    for (int i = 0; i < eeprom_bytes; ++i) fprintf(results, "%02x", bytes[i]);
    fprintf(results, "\n");
    return 0;
}

int main(int argc, char **argv) {
    elf_firmware_t firmware = {0};
    char line[256];
    if (argc < 4 || !(results = fopen(argv[3], "w")) || elf_read_firmware(argv[1], &firmware) != 0) return 2;
    inputs = atoi(argv[2]);
    strcpy(firmware.mmcu, "atmega328p");
    firmware.frequency = 16000000;
    firmware.vcc = firmware.avcc = firmware.aref = 5000;
    avr = avr_make_mcu_by_name(firmware.mmcu);
    avr_init(avr);
    avr->log = LOG_ERROR;
    avr_load_firmware(avr, &firmware);
    press(0);

    if (!fgets(line, sizeof line, stdin)) return 2;
    if (line[0] != '-') {
        uint8_t bytes[eeprom_bytes];
        unsigned byte, n = 0;
        while (n < eeprom_bytes && sscanf(line + 2 * n, "%2x", &byte) == 1) bytes[n++] = (uint8_t)byte;
        avr_eeprom_desc_t desc = {.ee = bytes, .offset = 0, .size = n};
        avr_ioctl(avr, AVR_IOCTL_EEPROM_SET, &desc);
    }
    if (argc > 4 && strcmp(argv[4], "calibrate") == 0) return calibrate();
    if (argc > 4 && strcmp(argv[4], "held") == 0) {
        if (!run_for(0.005)) return 1; /* until the pull-up is on; the sketch reads the button after 10 ms */
        press(1);
        return calibrate();
    }
    if (argc > 4 && strcmp(argv[4], "wait") == 0) {
        for (int i = 0; i < 40; ++i) {
            if (!run_for(0.1)) return 1;
            print_wheels();
        }
        return 0;
    }
    live = argc > 4;
    if (!start()) return 1;
    if (live) {
        avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_OUT_TRIGGER), on_conversion, NULL);
        return !run_for(1e6);
    }

    for (; steps < most_steps && fgets(line, sizeof line, stdin); ++steps) {
        char *at = line;
        for (int i = 0; i < inputs; ++i) counts[steps][i] = (int)strtol(at, &at, 10);
    }
    if (inputs == 0) {
        if (!run_for(0.2)) return 1;
        print_wheels();
        return 0;
    }
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_OUT_TRIGGER), on_conversion, NULL);
    /* A step that takes longer than the time between two shows as missing rows. */
    const char *step_ms = getenv("STEP_MS");
    return run_for(0.1 + (steps + 1) * 1.005e-3 * (step_ms ? atof(step_ms) : 20)) && step >= steps ? 0 : 1;
}
